#include "core/analysis/contour/contour_histogram.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr double least = 1e-6;  // mm; below it there is nothing to tell apart

/// The smallest of 1, 2 and 5 times a power of ten that is at least `value`.
double round_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  constexpr double rounding = 1 - 1e-9;
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= value * rounding) {
      return step * power;
    }
  }
  return 10 * power;
}

/// The next smaller of them; `value` is one.
double step_below(double value) {
  const double lead = value / std::pow(10, std::floor(std::log10(value) + 1e-9));
  return lead > 4 ? value * 0.4 : value * 0.5;
}

std::vector<double> edges_of(ContourBins bins, double largest) {
  const double top = std::max(largest, least);
  std::vector<double> edges;
  if (bins == ContourBins::logarithmic) {
    constexpr int steps = 12;  // four decades
    double edge = round_up(top);
    for (int i = 0; i <= steps; ++i, edge = step_below(edge)) {
      edges.push_back(edge);
    }
    edges.push_back(0);
    std::ranges::reverse(edges);
    return edges;
  }
  constexpr double bins_to_the_top = 20;
  const double step = round_up(top / bins_to_the_top);
  const auto count = static_cast<int>(std::ceil(top / step));
  if (bins == ContourBins::amounts) {
    for (int i = 0; i <= count; ++i) {
      edges.push_back(i * step);
    }
  } else if (bins == ContourBins::sides) {  // the middle bin is around 0
    for (int i = -count; i <= count + 1; ++i) {
      edges.push_back((i - 0.5) * step);
    }
  }
  return edges;
}

}  // namespace

HistogramCounter::HistogramCounter(ContourBins bins, double largest) {
  histogram_.edges = edges_of(bins, largest);
  histogram_.length.assign(histogram_.edges.empty() ? 0 : histogram_.edges.size() - 1, 0.0);
}

std::size_t HistogramCounter::bin_of(double value) const {
  const auto& edges = histogram_.edges;
  const auto after = std::ranges::upper_bound(edges, value) - edges.begin();
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - 1, 0, std::ssize(histogram_.length) - 1));
}

void HistogramCounter::add(double from, double to, double length) {
  if (histogram_.length.empty()) {
    return;
  }
  const auto [low, high] = std::minmax(from, to);
  const std::size_t first = bin_of(low);
  const std::size_t last = bin_of(high);
  if (first == last) {
    histogram_.length[first] += length;
    return;
  }
  for (std::size_t i = first; i <= last; ++i) {
    const double begin = i == first ? low : histogram_.edges[i];
    const double end = i == last ? high : histogram_.edges[i + 1];
    histogram_.length[i] += length * (end - begin) / (high - low);
  }
}

}  // namespace feedscope
