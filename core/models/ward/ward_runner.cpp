#include "core/models/ward/ward_runner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/models/ward/corner_pulse.h"
#include "core/models/ward/short_blocks.h"

namespace feedscope {

WardRunner::WardRunner(std::shared_ptr<const Toolpath> toolpath, const AxisVectors& axes,
                       const WardSettings& settings, const PathRules& rules, TrajectoryBuilder& builder)
    : toolpath_(std::move(toolpath)), axes_(axes), settings_(settings), rules_(rules), builder_(builder) {
  if (!(settings_.jerk > 0)) {
    settings_.jerk = axes.jerk.minCoeff();
  }
}

void WardRunner::run(const StretchRange& range, ProgressSteps& steps) {
  train_ = {toolpath_, range.first, settings_.filters, 0, 0, {}};
  train_.blocks.resize(range.last - range.first + 1);
  find_limits(range);
  choose_filter_time();
  if (settings_.enforce) {
    limit_arcs();
  }
  choose_corner_speeds();
  lay_pulses(train_, limits_, corner_speeds_);
  walk_.forget();
  if (settings_.enforce) {
    enforce_tolerance(steps);
  } else {
    measure_distances();
  }
  lay_motion(steps);
}

void WardRunner::find_limits(const StretchRange& range) {
  limits_.clear();
  for (std::size_t i = range.first; i < range.last; ++i) {
    limits_.push_back(segment_limits(*toolpath_, i, axes_).speed);
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

void WardRunner::choose_corner_speeds() {
  corner_speeds_.assign(train_.size(), 0);
  for (std::size_t i = 1; i < train_.size(); ++i) {
    corner_speeds_[i] =
        corner_speed(settings_.filters, train_.filter_time,
                     {limits_[i - 1].value, limits_[i].value, corner_turn(train_, i)}, corner_tolerance(i));
  }
  cap_by_short_blocks(train_, corner_speeds_);
}

}  // namespace feedscope
