#include "core/models/ward/ward_runner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/compressor/smoothed_points.h"
#include "core/models/ward/corner_pulse.h"
#include "core/models/ward/short_blocks.h"

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
  train_ = {
      commanded_, range.first, settings_.filters, 0, 0, {}, smoothed_ != nullptr ? programmed_ : nullptr};
  train_.blocks.resize(range.last - range.first + 1);
  find_limits(range);
  choose_filter_time();
  if (settings_.enforce) {
    limit_arcs();
  }
  choose_corner_speeds();
  walk_.forget();
  if (settings_.enforce) {
    enforce_tolerance(steps);
  } else {
    measure_distances();
  }
  lay_motion(steps);
}

void WardRunner::smooth_points(const StretchRange& range) {
  if (smoothed_ == nullptr) {
    return;
  }
  for (const SmoothCurve& curve : compressor_.compress(range.first, range.last)) {
    if (!curve.run.on_curve) {
      move_points(curve, *smoothed_);
    }
  }
}

void WardRunner::find_limits(const StretchRange& range) {
  limits_.clear();
  for (std::size_t i = range.first; i < range.last; ++i) {
    limits_.push_back(segment_limits(*commanded_, i, axes_).speed);
  }
}

void WardRunner::choose_filter_time() {
  double feed = 0;
  for (const SpeedBound& limit : limits_) {
    feed = std::max(feed, limit.value);
  }
  train_.filter_time = settings_.time > 0 ? settings_.time : std::sqrt(feed / settings_.jerk);
}

double WardRunner::arc_tolerance(std::size_t block) const {
  const double tolerance = rules_.tolerance(train_.first + block);
  return tolerance > 0 ? tolerance : std::numeric_limits<double>::infinity();
}

void WardRunner::limit_arcs() {
  for (std::size_t i = 0; i < train_.size(); ++i) {
    if (is_arc(i)) {
      limits_[i].lower(arc_speed(settings_.filters, train_.filter_time, train_.arc(i), arc_tolerance(i)),
                       {CauseKind::contour_tolerance});
    }
  }
}

/// Blocks too short for the pulses of their corners get a lower feed, which is that of the legs of these
/// corners: pulses and feeds are computed again until they settle (README.md beside this file). Where the
/// tolerance is enforced the first speeds are a start only, which the measured distances lower. Faster
/// corners make a shorter block's feed rise or fall, so that a few swing for ever: feeds that have not
/// settled after a few passes go half of the way to the new ones.
void WardRunner::choose_corner_speeds() {
  constexpr int max_passes = 200;
  constexpr double same = 1e-12;
  constexpr int quick_passes = 16;
  std::vector<double> alone(train_.size(), 0.0);  // speeds of the corners by their own legs
  std::vector<double> leg_feeds;                  // for which these hold
  for (const SpeedBound& limit : limits_) {
    leg_feeds.push_back(limit.value);
  }
  std::vector<char> moved(train_.size(), 1);
  for (int pass = 0; pass < max_passes; ++pass) {
    for (std::size_t i = 1; i < train_.size(); ++i) {
      if (moved[i - 1] != 0 || moved[i] != 0) {
        alone[i] =
            corner_speed(settings_.filters, train_.filter_time,
                         {leg_feeds[i - 1], leg_feeds[i], corner_turn(train_, i)}, corner_tolerance(i));
      }
    }
    corner_speeds_ = alone;
    cap_by_short_blocks(train_, corner_speeds_);
    lay_pulses(train_, limits_, corner_speeds_);
    if (settings_.enforce) {
      return;
    }
    bool any = false;
    for (std::size_t i = 0; i < train_.size(); ++i) {
      const double feed = train_.blocks[i].feed;
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
