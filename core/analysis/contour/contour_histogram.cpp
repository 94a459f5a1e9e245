#include "core/analysis/contour/contour_histogram.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace feedscope {
namespace {

constexpr double least = 1e-6;  // mm; smaller errors are not distinguished

/// Smallest 1, 2 or 5 times a power of ten that is at least `value`.
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

/// Next smaller such step; `value` is one.
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
  } else if (bins == ContourBins::sides) {  // the middle bin is centred on 0
    for (int i = -count; i <= count + 1; ++i) {
      edges.push_back((i - 0.5) * step);
    }
  }
  return edges;
}

/// Largest power of ten up to 1/400 of `largest`: half of every width of equal bins is a multiple of it.
double spread_step(double largest) {
  constexpr double steps_to_the_top = 400;
  return std::pow(10, std::floor(std::log10(std::max(largest, least) / steps_to_the_top)));
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

SpreadCounter::Line::Line(double first, double step, std::size_t bins)
    : first_(first), step_(step), single_(bins, 0.0), change_(bins + 1, 0.0) {}

void SpreadCounter::Line::add(double from, double to, double length) {
  const auto [low, high] = std::minmax(from, to);
  const auto bin_of = [this](double value) {
    const double bin = std::floor((value - first_) / step_);
    return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(single_.size() - 1)));
  };
  const std::size_t begin = bin_of(low);
  const std::size_t end = bin_of(high);
  if (begin == end) {
    single_[begin] += length;
    return;
  }
  const double by_value = length / (high - low);
  single_[begin] += by_value * (first_ + static_cast<double>(begin + 1) * step_ - low);
  single_[end] += by_value * (high - first_ - static_cast<double>(end) * step_);
  change_[begin + 1] += by_value * step_;
  change_[end] -= by_value * step_;
}

std::vector<double> SpreadCounter::Line::lengths() const {
  std::vector<double> lengths = single_;
  const double whole = std::accumulate(change_.begin(), change_.end(), 0.0,
                                       [](double sum, double change) { return sum + std::abs(change); });
  constexpr double rounding = 1e-12;
  double between = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    between += change_[i];
    lengths[i] += between > rounding * whole ? between : 0;
  }
  return lengths;
}

SpreadCounter::SpreadCounter(double largest)
    : SpreadCounter(
          spread_step(largest),
          static_cast<std::size_t>(std::ceil(std::max(largest, least) / spread_step(largest))) + 1) {}

SpreadCounter::SpreadCounter(double step, std::size_t bins)
    : step_(step), amount_(0, step, bins), side_(-step * static_cast<double>(bins), step, 2 * bins) {}

void SpreadCounter::add(double from, double to, double side_from, double side_to, double length) {
  amount_.add(from, to, length);
  side_.add(side_from, side_to, length);
  deviation_ += (from + to) / 2 * length;
  deviation_in_xy_ += (std::abs(side_from) + std::abs(side_to)) / 2 * length;
}

ContourSpread SpreadCounter::result() const {
  ContourSpread spread;
  spread.step = step_;
  spread.amount = amount_.lengths();
  const std::vector<double> sides = side_.lengths();
  const auto middle = sides.begin() + std::ssize(sides) / 2;
  spread.left.assign(middle, sides.end());
  spread.right.assign(std::make_reverse_iterator(middle), sides.rend());
  spread.in_plane = deviation_ > 0 ? deviation_in_xy_ / deviation_ : 0;
  return spread;
}

ContourHistogram histogram_of(const ContourSpread& spread, ContourBins bins, double largest) {
  HistogramCounter counter(bins, largest);
  const auto sum_up = [&](const std::vector<double>& lengths, double sign) {
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const double middle = sign * (static_cast<double>(i) + 0.5) * spread.step;
      counter.add(middle, middle, lengths[i]);
    }
  };
  if (bins == ContourBins::sides) {
    sum_up(spread.right, -1);
    sum_up(spread.left, 1);
  } else {
    sum_up(spread.amount, 1);
  }
  return counter.result();
}

}  // namespace feedscope
