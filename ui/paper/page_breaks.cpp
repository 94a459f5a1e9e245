#include "ui/paper/page_breaks.h"

#include <algorithm>
#include <limits>

namespace feedscope::ui {

namespace {

/// Reason for the end of a page.
enum class PageEnd { full, forced, last };

/// Cost of a page with `used` of its `height` filled.
double cost_of_page(double used, double height, PageEnd end) {
  constexpr double sliver = 0.06;
  const double fill = std::clamp(used / height, 0.0, 1.0);
  const double empty = 1 - fill;
  double cost = page_cost::page;
  cost += end == PageEnd::full ? page_cost::empty * empty * empty : 0;
  cost += end != PageEnd::last && fill < page_cost::min_fill ? page_cost::little * (1 + empty) : 0;
  cost += end == PageEnd::last && fill < sliver ? page_cost::sliver : 0;
  return cost;
}

}  // namespace

std::vector<std::size_t> best_page_breaks(std::span<const PageGap> gaps, double top, double bottom,
                                          double height) {
  constexpr double rounding = 1e-6;
  const std::size_t count = gaps.size();
  // Place i: where page breaks i - 1 is; 0: the top, count + 1: the bottom.
  std::vector<double> least(count + 2, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(count + 2, 0);
  least[0] = 0;
  const auto start = [&](std::size_t i) { return i == 0 ? top : gaps[i - 1].below - gaps[i - 1].head; };
  for (std::size_t end = 1; end <= count + 1; ++end) {
    const bool last = end == count + 1;
    const double until = last ? bottom : gaps[end - 1].above;
    const PageEnd why = last ? PageEnd::last : gaps[end - 1].forced ? PageEnd::forced : PageEnd::full;
    const double breaking = why == PageEnd::full ? gaps[end - 1].cost : 0;
    for (std::size_t begin = end; begin-- > 0;) {
      const double used = until - start(begin);
      if (used > height + rounding && begin + 1 < end) {
        break;
      }
      const double cost = least[begin] + breaking + cost_of_page(used, height, why);
      if (cost < least[end]) {
        least[end] = cost;
        from[end] = begin;
      }
      if (begin > 0 && gaps[begin - 1].forced) {
        break;
      }
    }
  }
  std::vector<std::size_t> breaks;
  for (std::size_t place = from[count + 1]; place > 0; place = from[place]) {
    breaks.push_back(place - 1);
  }
  std::ranges::reverse(breaks);
  return breaks;
}

}  // namespace feedscope::ui
