#include "core/models/ward/ward_runner.h"

#include <algorithm>
#include <cmath>

#include "core/blend/junction.h"
#include "core/models/ward/corner_pulse.h"

namespace feedscope {
namespace {

constexpr double sagitta_share = 0.1;  // of the tolerance, for the chords of an arc
constexpr double finest_chord = 1e-3;  // [rad]
constexpr double widest_chord = 0.1;   // [rad]

}  // namespace

WardRunner::WardRunner(const Toolpath& toolpath, const AxisVectors& axes, const WardSettings& settings,
                       TrajectoryBuilder& builder)
    : toolpath_(toolpath), axes_(axes), settings_(settings), builder_(builder) {
  if (!(settings_.jerk > 0)) {
    settings_.jerk = axes.jerk.minCoeff();
  }
}

void WardRunner::run(const StretchRange& range, ProgressSteps& steps) {
  lay_links(range);
  choose_filter_time();
  choose_corner_speeds();
  if (settings_.enforce) {
    enforce_tolerance(steps);
  }
  PulseTrain train = lay_pulses(links_, half_delay_, corner_speeds_, end_);
  link_start_ = std::move(train.link_start);
  lay_motion(range, smooth(std::move(train.pulses)), steps);
}

void WardRunner::lay_links(const StretchRange& range) {
  links_.clear();
  end_ = toolpath_.segments[range.last - 1].end;
  for (std::size_t i = range.first; i < range.last; ++i) {
    const MotionLimits limits = segment_limits(toolpath_, i, axes_);
    if (toolpath_.segments[i].kind == SegmentKind::arc) {
      add_arc_links(i, limits);
    } else {
      links_.push_back({toolpath_.start_of(i), toolpath_.tangent_at_start(i), toolpath_.segments[i].length,
                        limits.speed, 0, static_cast<std::uint32_t>(i)});
    }
  }
  for (std::size_t i = 0; i + 1 < links_.size(); ++i) {
    links_[i].turn = turn_angle(links_[i].direction, links_[i + 1].direction);
  }
}

void WardRunner::add_arc_links(std::size_t segment, const MotionLimits& limits) {
  const Arc& arc = toolpath_.arcs[static_cast<std::size_t>(toolpath_.segments[segment].arc)];
  const double chord =
      std::clamp(std::sqrt(8 * sagitta_share * settings_.tolerance / arc.radius), finest_chord, widest_chord);
  const double count = std::ceil(arc.sweep / chord);
  const double step = arc.length() / count;
  Vec3 start = toolpath_.start_of(segment);
  for (double k = 1; k <= count; ++k) {
    const Vec3 end = k == count ? toolpath_.segments[segment].end : arc.at(k * step).position;
    const double length = (end - start).norm();
    SpeedBound feed = limits.speed;
    feed.value *= length / step;  // the arc's time, not the chord's
    links_.push_back({start, (end - start) / length, length, feed, 0, static_cast<std::uint32_t>(segment)});
    start = end;
  }
}

void WardRunner::choose_filter_time() {
  double feed = 0;
  for (const Link& link : links_) {
    feed = std::max(feed, link.feed.value);
  }
  filter_time_ = settings_.time > 0 ? settings_.time : std::sqrt(feed / settings_.jerk);
  half_delay_ = settings_.filters * filter_time_ / 2;
}

void WardRunner::choose_corner_speeds() {
  corner_speeds_.assign(links_.size() + 1, 0);
  for (std::size_t i = 1; i < links_.size(); ++i) {
    corner_speeds_[i] = corner_speed(settings_.filters, filter_time_,
                                     {links_[i - 1].feed.value, links_[i].feed.value, links_[i - 1].turn},
                                     settings_.tolerance);
  }
  cap_by_short_blocks(links_, half_delay_, corner_speeds_);
}

FilteredMotion WardRunner::smooth(std::vector<Pulse> pulses) const {
  return {settings_.filters, filter_time_, builder_.time(), std::move(pulses)};
}

void WardRunner::enforce_tolerance(ProgressSteps& steps) {
  check_.assign(corner_speeds_.size(), 1);
  std::vector<double> before;
  for (int pass = 0;; ++pass) {
    steps.at(links_.front().segment);
    PulseTrain train = lay_pulses(links_, half_delay_, corner_speeds_, end_);
    link_start_ = std::move(train.link_start);
    before = corner_speeds_;
    if (!lower_corners(smooth(std::move(train.pulses)), pass)) {
      return;
    }
    cap_by_short_blocks(links_, half_delay_, corner_speeds_);
    mark_neighbours(before);
  }
}

bool WardRunner::lower_corners(const FilteredMotion& motion, int pass) {
  // Where corners are dense their distance goes with the square of the speed. The later passes end what
  // converges too slowly, at the latest by a stop in the corner.
  constexpr double aim = 0.98;
  constexpr double slack = 1e-6;
  constexpr int careful_passes = 16;
  constexpr int last_passes = 24;
  bool lowered = false;
  for (std::size_t i = 1; i < links_.size(); ++i) {
    if (!check_[i]) {
      continue;
    }
    check_[i] = 0;
    const double distance = approach(motion, i, settings_.tolerance).distance;
    if (distance <= settings_.tolerance * (1 + slack) || corner_speeds_[i] == 0) {
      continue;
    }
    double factor = std::sqrt(aim * settings_.tolerance / distance);
    if (pass >= careful_passes) {
      factor = pass < last_passes ? std::min(factor, 0.5) : 0;
    }
    corner_speeds_[i] *= factor;
    lowered = true;
  }
  return lowered;
}

void WardRunner::mark_neighbours(const std::vector<double>& speeds_before) {
  const double window = 2 * half_delay_;
  std::size_t unmarked = 1;
  for (std::size_t i = 1; i < links_.size(); ++i) {
    if (corner_speeds_[i] == speeds_before[i]) {
      continue;
    }
    for (std::size_t k = i; k >= unmarked && link_start_[i] - link_start_[k] <= window; --k) {
      check_[k] = 1;
    }
    std::size_t k = std::max(i, unmarked);
    for (; k < links_.size() && link_start_[k] - link_start_[i] <= window; ++k) {
      check_[k] = 1;
    }
    unmarked = k;
  }
}

WardRunner::Approach WardRunner::approach(const FilteredMotion& motion, std::size_t corner,
                                          double good_enough) const {
  constexpr int newton_steps = 4;
  Approach best{std::numeric_limits<double>::infinity(), 0};
  double time = link_start_[corner] + half_delay_;
  for (int i = 0; i < newton_steps; ++i) {
    const Kinematics at = motion.at(time);
    const Vec3 offset = at.position - links_[corner].start;
    if (offset.norm() < best.distance) {
      best = {offset.norm(), time};
    }
    const double slope = offset.dot(at.velocity);
    const double curvature = at.velocity.squaredNorm() + offset.dot(at.acceleration);
    if (best.distance <= good_enough || !(curvature > 0) ||
        std::abs(slope) <= 1e-9 * offset.norm() * at.velocity.norm()) {
      break;
    }
    time += std::clamp(-slope / curvature, -half_delay_ / 2, half_delay_ / 2);
  }
  return best;
}

}  // namespace feedscope
