#include <algorithm>
#include <cmath>

#include "core/models/essid/essid_stretch.h"

namespace feedscope {
namespace {

/// Blends that turn by more than this [rad] are level places of the plan: run over within a longer ramp, at a
/// speed that hardly changes, they would exceed the radial jerk share by more than 3.3 (0.66 of the axis).
constexpr double level_turn = 0.5;

/// A line shorter than this [mm] between two blends is left out.
constexpr double least_line = 1e-12;

double least_radius(const BlendShape& shape) {
  constexpr int intervals = 32;
  double largest = 0;
  for (int i = 0; i <= intervals; ++i) {
    largest = std::max(largest, shape.at(static_cast<double>(i) / intervals).k);
  }
  return 1 / largest;
}

}  // namespace

EssidRunner::EssidRunner(const Toolpath& toolpath, const AxisVectors& axes, const EssidSettings& settings,
                         TrajectoryBuilder& builder)
    : toolpath_(toolpath),
      axes_(axes),
      blend_limits_(axes, settings.radial_acceleration_share, settings.radial_jerk_share),
      settings_(settings),
      builder_(builder) {}

void EssidRunner::run(const StretchRange& range, ProgressSteps& steps) {
  lay_path(range);
  set_junction_ceilings(stretch_, builder_.path(), axes_.jerk, settings_.period, settings_.lookahead);
  hold_level_blends();
  move(plan_nodes(stretch_.plan, stretch_.ceiling, level_), steps);
}

void EssidRunner::lay_path(const StretchRange& range) {
  stretch_.clear();
  blend_index_.clear();
  blends_.clear();
  double cut_before = 0;
  for (std::size_t i = range.first; i < range.last; ++i) {
    Corner corner;
    const bool blended = i + 1 < range.last && junction_kind(toolpath_, i + 1) == JunctionKind::corner;
    const Vec3 in = toolpath_.tangent_at_end(i);
    const Vec3 out = blended ? toolpath_.tangent_at_start(i + 1) : in;
    if (blended) {
      const double longest = std::min(toolpath_.segments[i].length, toolpath_.segments[i + 1].length) / 2;
      corner = lay_corner(in, out, longest, settings_.corner);
    }
    add_straight(i, cut_before, corner.transition);
    if (blended) {
      add_blend(i, corner, in, out);
    }
    cut_before = corner.transition;
  }
}

void EssidRunner::add_straight(std::size_t segment, double cut_before, double cut_after) {
  const double length = toolpath_.segments[segment].length - cut_before - cut_after;
  if (length <= least_line) {
    return;
  }
  const double feed = programmed_speed(toolpath_, segment, axes_.velocity).value;
  const std::uint32_t index = builder_.add_segment(toolpath_, segment, feed, cut_before, cut_after);
  stretch_.add({length, segment_limits(toolpath_, segment, axes_)}, index,
               static_cast<std::uint32_t>(segment));
  blend_index_.push_back(no_blend);
}

void EssidRunner::add_blend(std::size_t segment, const Corner& corner, const Vec3& in, const Vec3& out) {
  const Segment& before = toolpath_.segments[segment];
  SpeedBound feed = programmed_speed(toolpath_, segment, axes_.velocity);
  const SpeedBound next = programmed_speed(toolpath_, segment + 1, axes_.velocity);
  const double programmed = feed.value;
  feed.lower(next.value, next.cause);

  const CubicBlend curve = corner_blend(before.end, in, out, corner.transition, settings_.corner.alpha);
  const BlendShape shape(in, out, corner.transition, settings_.corner.alpha);
  PathElement element;
  element.kind = ElementKind::blend;
  element.start = curve.start;
  element.end = curve.end;
  element.length = curve.length();
  element.segment = static_cast<std::uint32_t>(segment);
  element.geometry = builder_.add_blend(curve);
  const std::uint32_t index = builder_.add_element(element, before.line, programmed, false);
  builder_.add_blend_record({before.line, index, before.end, corner.turn, corner.transition, corner.epsilon,
                             element.length, least_radius(shape), 0, 0});

  SpeedBound speed = entry_speed_limit(shape.at(0), feed, blend_limits_);
  if (settings_.reading == EssidReading::strict) {
    speed = steady_speed_limit(shape, feed, blend_limits_);
  } else if (corner.turn > sharp_turn) {
    const SpeedBound steady = steady_speed_limit(shape, feed, blend_limits_);
    speed.lower(steady.value, steady.cause);
  }
  const MotionLimits limits = blend_motion_limits(shape, speed, blend_limits_);
  stretch_.add({element.length, limits}, index, static_cast<std::uint32_t>(segment));
  blend_index_.push_back(static_cast<std::int32_t>(blends_.size()));
  blends_.push_back({shape, feed, corner.turn, limits.jerk.value});
}

bool EssidRunner::is_level(const Blend& blend) const {
  return settings_.reading == EssidReading::strict || blend.turn > level_turn;
}

void EssidRunner::hold_level_blends() {
  level_.clear();
  constexpr double none = 1e-12;  // [mm/s2, mm/s3]: both ends of a blend get the same speed
  for (std::uint32_t e = 0; e < stretch_.plan.size(); ++e) {
    if (blend_index_[e] == no_blend || !is_level(blend_of(e))) {
      continue;
    }
    stretch_.plan[e].limits.acceleration.value = stretch_.plan[e].limits.jerk.value = none;
    if (level_.empty() || level_.back() < e) {
      level_.push_back(e);
    }
    level_.push_back(e + 1);
  }
}

}  // namespace feedscope
