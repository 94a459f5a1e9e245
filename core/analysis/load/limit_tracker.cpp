#include "core/analysis/load/limit_tracker.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr double same_instant = 1e-9;  // [s]

/// Share of the range from `a` to `b` in which a linearly changing value is above 0; none if to <= from.
struct ShareAbove {
  double from = 0;
  double to = 0;
};
ShareAbove above_zero(double a, double b) {
  if (a > 0 && b > 0) {
    return {0, 1};
  }
  if (a <= 0 && b <= 0) {
    return {0, 0};
  }
  const double crossing = a / (a - b);
  return a > 0 ? ShareAbove{0, crossing} : ShareAbove{crossing, 1};
}

bool is_longer(const LoadPlace& a, const LoadPlace& b) {
  const double lengths = (a.to - a.from) - (b.to - b.from);
  return lengths != 0 ? lengths > 0 : a.from < b.from;
}

}  // namespace

std::optional<double> bound_of(LoadLimit limit, const Engagement& operation) {
  switch (limit) {
    case LoadLimit::least_chip:
      return operation.least_chip;
    case LoadLimit::max_chip:
      return operation.max_chip;
    case LoadLimit::max_force:
      return operation.max_force;
    case LoadLimit::max_torque:
      return operation.max_torque;
    case LoadLimit::max_power:
      return operation.max_power;
  }
  return std::nullopt;
}

void LimitTracker::add(const Look& from, const Look& to, int operation, double bound) {
  const double sign = figures_.limit == LoadLimit::least_chip ? -1 : 1;
  const double duration = to.time - from.time;
  const ShareAbove beyond = above_zero(sign * (from.predicted - bound), sign * (to.predicted - bound));
  const ShareAbove programmed = above_zero(sign * (from.programmed - bound), sign * (to.programmed - bound));
  figures_.programmed_time += (programmed.to - programmed.from) * duration;
  if (beyond.to > beyond.from) {
    figures_.time += (beyond.to - beyond.from) * duration;
    extend(from.time + beyond.from * duration, from.time + beyond.to * duration, from, to, operation);
  }
}

void LimitTracker::extend(double from, double to, const Look& a, const Look& b, int operation) {
  const bool least = figures_.limit == LoadLimit::least_chip;
  const double worst = least ? std::min(a.predicted, b.predicted) : std::max(a.predicted, b.predicted);
  const auto [first_line, last_line] = std::minmax(a.line, b.line);
  if (open_ && open_->operation == operation && from - open_->to < same_instant) {
    open_->to = to;
    open_->first_line = std::min(open_->first_line, first_line);
    open_->last_line = std::max(open_->last_line, last_line);
    open_->worst = least ? std::min(open_->worst, worst) : std::max(open_->worst, worst);
    return;
  }
  close();
  open_ = LoadPlace{operation, from, to, first_line, last_line, worst};
}

void LimitTracker::close() {
  if (!open_) {
    return;
  }
  ++figures_.count;
  figures_.places.push_back(*open_);
  open_.reset();
  if (figures_.places.size() >= 2 * LimitFigures::most_places) {
    keep_longest();
  }
}

void LimitTracker::keep_longest() {
  std::vector<LoadPlace>& places = figures_.places;
  if (places.size() > LimitFigures::most_places) {
    const auto end = places.begin() + static_cast<std::ptrdiff_t>(LimitFigures::most_places);
    std::nth_element(places.begin(), end, places.end(), is_longer);
    places.erase(end, places.end());
  }
}

LimitFigures LimitTracker::finish() {
  close();
  keep_longest();
  std::sort(figures_.places.begin(), figures_.places.end(),
            [](const LoadPlace& a, const LoadPlace& b) { return a.from < b.from; });
  return std::move(figures_);
}

}  // namespace feedscope
