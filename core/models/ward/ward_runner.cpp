#include "core/models/ward/ward_runner.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/compressor/smoothed_points.h"
#include "core/models/ward/corner_pulse.h"
#include "core/models/ward/short_blocks.h"
#include "core/models/ward/ward_motion.h"
#include "core/models/ward/ward_tolerance.h"
#include "core/trajectory/filtered_corner.h"

namespace feedscope {

WardRunner::WardRunner(std::shared_ptr<const Toolpath> toolpath, std::shared_ptr<Toolpath> smoothed,
                       const AxisVectors& axes, const WardSettings& settings, const PathRules& rules,
                       TrajectoryBuilder& builder)
    : programmed_(std::move(toolpath)),
      smoothed_(std::move(smoothed)),
      commanded_(smoothed_ != nullptr ? smoothed_ : programmed_),
      compressor_(*programmed_, rules, settings.compressor),
      axes_(axes),
      settings_(settings),
      rules_(rules),
      builder_(builder) {
  if (!(settings_.jerk > 0)) {
    settings_.jerk = axes.jerk.minCoeff();
  }
}

void WardRunner::run(const StretchRange& range, ProgressSteps& steps) {
  smooth_points(range);
  WardPulses pulses = empty_pulses(range);
  hold_turns(pulses);
  if (settings_.enforce) {
    limit_arcs(pulses);
  }
  choose_corner_speeds(pulses);
  const double error = keep_tolerance(pulses, steps);
  WardMotion(std::move(pulses), builder_).lay(error, steps);
}

double WardRunner::keep_tolerance(WardPulses& pulses, ProgressSteps& steps) const {
  WardTolerance tolerance(pulses, rules_, builder_.progress());
  if (settings_.enforce) {
    tolerance.enforce(steps);
  } else {
    tolerance.measure();
  }
  return tolerance.largest();
}

void WardRunner::smooth_points(const StretchRange& range) {
  if (smoothed_ == nullptr) {
    return;
  }
  for (const SmoothCurve& curve : compressor_.compress(range.first, range.last, builder_.progress())) {
    if (!curve.run.on_curve) {
      move_points(curve, *smoothed_);
    }
  }
}

WardPulses WardRunner::empty_pulses(const StretchRange& range) const {
  WardPulses pulses;
  pulses.train = {
      commanded_, range.first, settings_.filters, 0, 0, {}, smoothed_ != nullptr ? programmed_ : nullptr};
  pulses.train.blocks.resize(range.last - range.first + 1);
  pulses.limits.reserve(range.last - range.first);
  double feed = 0;
  for (std::size_t i = range.first; i < range.last; ++i) {
    pulses.limits.push_back(segment_limits(*commanded_, i, axes_).speed);
    feed = std::max(feed, pulses.limits.back().value);
  }
  pulses.train.filter_time = settings_.time > 0 ? settings_.time : std::sqrt(feed / settings_.jerk);
  return pulses;
}

/// A block along which an axis reaches its velocity because rotary axes turn also limits the blocks before
/// and after it, within twice the reach of the filters: they mix the speeds of neighbours by one half of it
/// and shift the place by the other. The limit is the least of a window that slides over the blocks by their
/// times.
void WardRunner::hold_turns(WardPulses& pulses) const {
  if (commanded_->turn_ceiling == nullptr) {
    return;
  }
  const std::size_t count = pulses.limits.size();
  const double window = pulses.train.delay();
  std::vector<SpeedBound> turning;
  std::vector<double> begins{0};
  for (std::size_t i = 0; i < count; ++i) {
    turning.push_back(turning_ceiling(*commanded_, pulses.train.first + i, nullptr));
    if (turning.back().cause.kind != CauseKind::axis_velocity) {
      turning.back().value = HUGE_VAL;
    }
    begins.push_back(begins.back() + pulses.train.segment(i).length / pulses.limits[i].value);
  }
  std::deque<std::size_t> least;  // of the window, rising
  std::size_t next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (; next < count && begins[next] < begins[i + 1] + window; ++next) {
      while (!least.empty() && turning[least.back()].value >= turning[next].value) {
        least.pop_back();
      }
      least.push_back(next);
    }
    while (begins[least.front() + 1] < begins[i] - window) {
      least.pop_front();
    }
    pulses.limits[i].lower(turning[least.front()].value, turning[least.front()].cause);
  }
}

void WardRunner::limit_arcs(WardPulses& pulses) const {
  for (std::size_t i = 0; i < pulses.train.size(); ++i) {
    if (pulses.is_arc(i)) {
      pulses.limits[i].lower(arc_speed(settings_.filters, pulses.train.filter_time, pulses.train.arc(i),
                                       pulses.arc_tolerance(rules_, i)),
                             {CauseKind::contour_tolerance});
    }
  }
}

/// Blocks too short for the pulses of their corners get a lower feed, which is also that of the legs of these
/// corners: pulses and feeds are computed again until they settle (README.md in this folder). Where the
/// tolerance is enforced the first speeds are only a start, which the measured distances lower. Faster
/// corners may raise or lower a shorter block's feed, so that a few oscillate: feeds that have not settled
/// after a few passes move half of the way to the new ones.
void WardRunner::choose_corner_speeds(WardPulses& pulses) const {
  PulseTrain& train = pulses.train;
  constexpr int max_passes = 200;
  constexpr double same = 1e-12;
  constexpr int quick_passes = 16;
  std::vector<double> alone(train.size(), 0.0);  // speeds of the corners by their own legs
  std::vector<double> leg_feeds;                 // feeds for which these are valid
  for (const SpeedBound& limit : pulses.limits) {
    leg_feeds.push_back(limit.value);
  }
  std::vector<char> moved(train.size(), 1);
  for (int pass = 0; pass < max_passes; ++pass) {
    stop_if_cancelled(builder_.progress());
    for (std::size_t i = 1; i < train.size(); ++i) {
      if (moved[i - 1] != 0 || moved[i] != 0) {
        alone[i] = corner_speed(settings_.filters, train.filter_time,
                                {leg_feeds[i - 1], leg_feeds[i], corner_turn(train, i)},
                                pulses.corner_tolerance(rules_, i));
      }
    }
    pulses.corner_speeds = alone;
    cap_by_short_blocks(train, pulses.corner_speeds);
    lay_pulses(train, pulses.limits, pulses.corner_speeds);
    if (settings_.enforce) {
      return;
    }
    bool any = false;
    for (std::size_t i = 0; i < train.size(); ++i) {
      const double feed = train.blocks[i].feed;
      moved[i] = std::abs(feed - leg_feeds[i]) > same * feed ? 1 : 0;
      if (moved[i] != 0) {
        leg_feeds[i] += (pass < quick_passes ? 1.0 : 0.5) * (feed - leg_feeds[i]);
        any = true;
      }
    }
    if (!any) {
      return;
    }
  }
}

}  // namespace feedscope
