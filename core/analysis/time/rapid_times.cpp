#include "core/analysis/time/rapid_times.h"

#include <algorithm>

namespace feedscope {

namespace {

constexpr double nanosecond = 1e-9;

}  // namespace

void RapidTimes::add(double from, double to) {
  if (!to_.empty() && from <= to_.back() + nanosecond) {
    to_.back() = std::max(to_.back(), to);
  } else {
    from_.push_back(from);
    to_.push_back(to);
  }
}

std::vector<ColumnStretch> RapidTimes::outside(std::span<const double> times) const {
  std::vector<ColumnStretch> stretches;
  if (times.empty()) {
    return stretches;
  }
  auto rapid = static_cast<std::size_t>(std::ranges::upper_bound(to_, times.front()) - to_.begin());
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    double from = times[i];
    const auto add_until = [&](double to) {
      if (to > from) {
        stretches.push_back({i, from, to});
      }
    };
    while (rapid < from_.size() && from_[rapid] < times[i + 1]) {
      add_until(from_[rapid] - nanosecond);
      from = std::max(from, to_[rapid] + nanosecond);
      if (to_[rapid] > times[i + 1]) {
        break;  // it extends into the next column
      }
      ++rapid;
    }
    add_until(times[i + 1]);
  }
  return stretches;
}

}  // namespace feedscope
