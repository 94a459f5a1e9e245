#include "core/analysis/rotary/rotary_peak_search.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr std::size_t per_axis = 3;

double AxisPeaks::*const peak_of[per_axis] = {&AxisPeaks::velocity, &AxisPeaks::acceleration,
                                              &AxisPeaks::jerk};

/// Rise of the parabola through three places above the middle one, which is the largest of the three.
double rise_of_parabola(double before, double at, double after, double from, double middle, double to) {
  const double left = (middle - before) / (at - from);
  const double right = (after - middle) / (to - at);
  const double bend = (right - left) / (to - from);
  if (!(bend < 0)) {
    return 0;
  }
  const double slope = left + bend * (at - from);
  return slope * slope / (-4 * bend);
}

}  // namespace

RotaryPeakSearch::Look RotaryPeakSearch::look(RotaryWalk& walk, double time) {
  const RotarySample sample = walk.sample(time);
  Look look{time, {}, {}};
  const auto add = [&](const std::array<AxisState, 3>& axes, std::array<AxisPeaks, 3>& peaks,
                       std::size_t first) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      peaks[i].add(axes[i].velocity, axes[i].acceleration, axes[i].jerk);
      look.of[first + per_axis * i] = std::abs(axes[i].velocity);
      look.of[first + per_axis * i + 1] = std::abs(axes[i].acceleration);
      look.of[first + per_axis * i + 2] = std::abs(axes[i].jerk);
      look.slope[first + per_axis * i] =
          std::copysign(axes[i].acceleration, axes[i].acceleration * axes[i].velocity);
      look.slope[first + per_axis * i + 1] = std::copysign(axes[i].jerk, axes[i].jerk * axes[i].acceleration);
    }
  };
  add(sample.rotary, rotary_, 0);
  if (!std::isnan(sample.linear.front().velocity)) {
    linear_ = linear_.value_or(std::array<AxisPeaks, 3>{});
    add(sample.linear, *linear_, count / 2);
  }
  return look;
}

double RotaryPeakSearch::found(std::size_t quantity) const {
  const std::size_t axis = quantity / per_axis;
  const AxisPeaks none;
  const AxisPeaks& peaks = axis < rotary_.size() ? rotary_[axis]
                           : linear_             ? (*linear_)[axis - rotary_.size()]
                                                 : none;
  return peaks.*peak_of[quantity % per_axis];
}

/// Golden sections for each quantity that may exceed its largest value so far.
void RotaryPeakSearch::narrow(RotaryWalk& walk, const Look& before, const Look& at, const Look& after) {
  constexpr double doubt = 4;  // a peak may be narrower than the parabola
  for (std::size_t q = 0; q < count; ++q) {
    if (!(at.of[q] >= before.of[q] && at.of[q] >= after.of[q] && at.of[q] > 0)) {
      continue;
    }
    const double rise =
        rise_of_parabola(before.of[q], at.time, after.of[q], before.time, at.of[q], after.time);
    if (at.of[q] + doubt * rise <= found(q)) {
      continue;
    }
    search(walk, q, before.time, after.time);
  }
}

/// The magnitude increases at `from` and decreases at `to`: the tangents at both bound it in between.
void RotaryPeakSearch::narrow_between(RotaryWalk& walk, const Look& from, const Look& to) {
  const double time = to.time - from.time;
  for (std::size_t q = 0; q < count; ++q) {
    if (!(from.slope[q] > 0 && to.slope[q] < 0)) {
      continue;
    }
    const double most = std::min(from.of[q] + from.slope[q] * time, to.of[q] - to.slope[q] * time);
    if (most > found(q)) {
      search(walk, q, from.time, to.time);
    }
  }
}

void RotaryPeakSearch::search(RotaryWalk& walk, std::size_t quantity, double low, double high) {
  constexpr int sections = 24;
  constexpr double golden = 0.6180339887498949;
  double left = high - golden * (high - low);
  double right = low + golden * (high - low);
  double at_left = look(walk, left).of[quantity];
  double at_right = look(walk, right).of[quantity];
  for (int i = 0; i < sections; ++i) {
    if (at_left < at_right) {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = look(walk, right).of[quantity];
    } else {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = look(walk, left).of[quantity];
    }
  }
}

/// The largest magnitude may be between the end of a part and the sample next to it.
void RotaryPeakSearch::narrow_at_end(RotaryWalk& walk, const Look& end, const Look& next) {
  constexpr double doubt = 2;
  constexpr double beside = 1e-3;  // of the interval: whether a magnitude increases at first
  for (std::size_t q = 0; q < count; ++q) {
    if (end.of[q] >= next.of[q] && end.of[q] + doubt * (end.of[q] - next.of[q]) > found(q)) {
      const Look at = look(walk, end.time + beside * (next.time - end.time));
      const bool is_first = end.time < next.time;
      narrow(walk, is_first ? end : next, at, is_first ? next : end);
      return;
    }
  }
}

void RotaryPeakSearch::add(RotaryWalk& walk) {
  times_ = walk.turning_places();
  const bool changes_within = !times_.empty();
  const RotaryLooks usual = walk.looks();
  for (int i = 0; i < usual.count(); ++i) {
    times_.push_back(usual.at(i));
  }
  std::ranges::sort(times_);
  if (changes_within) {
    look_closer();
  }
  looks_.clear();
  for (const double time : times_) {
    if (looks_.empty() || time > looks_.back().time) {
      looks_.push_back(look(walk, time));
    }
  }
  const std::size_t last = looks_.size() - 1;
  for (std::size_t i = 1; i < last; ++i) {
    narrow(walk, looks_[i - 1], looks_[i], looks_[i + 1]);
  }
  for (std::size_t i = 1; i <= last; ++i) {
    narrow_between(walk, looks_[i - 1], looks_[i]);
  }
  if (last > 0) {
    narrow_at_end(walk, looks_[0], looks_[1]);
    narrow_at_end(walk, looks_[last], looks_[last - 1]);
  }
}

/// Adds samples half way between neighbours and close to both, where several laws follow each other.
void RotaryPeakSearch::look_closer() {
  const std::size_t known = times_.size();
  for (std::size_t i = 1; i < known; ++i) {
    const double step = times_[i] - times_[i - 1];
    for (const double share : {0.001, 0.5, 0.999}) {
      times_.push_back(times_[i - 1] + share * step);
    }
  }
  std::ranges::sort(times_);
}

}  // namespace feedscope
