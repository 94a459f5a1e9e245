#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/models/essid/stretch.h"

namespace feedscope {
namespace {

/// Up to this direction change [rad] a junction that touches an arc counts as tangent: what three decimals of
/// a millimetre do to the centre of an arc of radius 0.1 mm.
constexpr double tangent_angle = 0.01;

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

JunctionKind junction_kind(const Toolpath& toolpath, std::size_t i) {
  const double turn = turn_angle(toolpath.tangent_at_end(i - 1), toolpath.tangent_at_start(i));
  if (turn <= straight_angle) {
    return JunctionKind::pass;
  }
  const bool lines =
      toolpath.segments[i - 1].kind == SegmentKind::line && toolpath.segments[i].kind == SegmentKind::line;
  if (!lines) {
    return turn <= tangent_angle ? JunctionKind::pass : JunctionKind::stop;
  }
  return turn >= units::pi - straight_angle ? JunctionKind::stop : JunctionKind::blend;
}

StretchRunner::StretchRunner(const Toolpath& toolpath, const AxisVectors& axes, const EssidSettings& settings,
                             TrajectoryBuilder& builder)
    : toolpath_(toolpath),
      axes_(axes),
      blend_limits_(axes, settings.radial_acceleration_share, settings.radial_jerk_share),
      settings_(settings),
      builder_(builder) {}

void StretchRunner::run(std::size_t first, std::size_t last, Progress* progress) {
  lay_path(first, last);
  set_junction_ceilings();
  hold_level_blends();
  const std::vector<PlanNode> nodes = plan_nodes(plan_, ceiling_, level_);
  move(nodes, last - first, first, progress);
}

void StretchRunner::lay_path(std::size_t first, std::size_t last) {
  plan_.clear();
  elements_.clear();
  blends_.clear();
  block_of_.clear();
  double cut_before = 0;
  for (std::size_t i = first; i < last; ++i) {
    Corner corner;
    const bool blended = i + 1 < last && junction_kind(toolpath_, i + 1) == JunctionKind::blend;
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

void StretchRunner::add_straight(std::size_t segment, double cut_before, double cut_after) {
  const Segment& programmed = toolpath_.segments[segment];
  const double length = programmed.length - cut_before - cut_after;
  if (length <= least_line) {
    return;
  }
  const MotionLimits limits = segment_limits(toolpath_, segment, axes_);
  const double feed = programmed_speed(toolpath_, segment, axes_.velocity).value;
  std::uint32_t index = 0;
  if (programmed.kind == SegmentKind::arc) {
    index = builder_.add_segment(toolpath_, segment, feed);
  } else {
    const Vec3 direction = toolpath_.tangent_at_start(segment);
    PathElement element;
    element.start = toolpath_.start_of(segment) + cut_before * direction;
    element.end = programmed.end - cut_after * direction;
    element.length = length;
    element.segment = static_cast<std::uint32_t>(segment);
    index = builder_.add_element(element, programmed.line, feed, programmed.rapid);
  }
  plan_.push_back({length, limits});
  elements_.push_back({index, -1});
  block_of_.push_back(static_cast<std::uint32_t>(segment));
}

void StretchRunner::add_blend(std::size_t segment, const Corner& corner, const Vec3& in, const Vec3& out) {
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
  const std::size_t record =
      builder_.add_blend_record({before.line, index, before.end, corner.turn, corner.transition,
                                 corner.epsilon, element.length, least_radius(shape), 0, 0});

  SpeedBound speed = entry_speed_limit(shape.at(0), feed, blend_limits_);
  if (settings_.reading == EssidReading::strict) {
    speed = steady_speed_limit(shape, feed, blend_limits_);
  } else if (corner.turn > sharp_turn) {
    const SpeedBound steady = steady_speed_limit(shape, feed, blend_limits_);
    speed.lower(steady.value, steady.cause);
  }
  plan_.push_back({element.length, blend_motion_limits(shape, speed, blend_limits_)});
  elements_.push_back({index, static_cast<std::int32_t>(blends_.size())});
  blends_.push_back({shape, feed, record, corner.turn, plan_.back().limits.jerk.value});
  block_of_.push_back(static_cast<std::uint32_t>(segment));
}

void StretchRunner::set_junction_ceilings() {
  const std::size_t count = plan_.size();
  ceiling_.assign(count + 1, 0);
  for (std::size_t j = 1; j < count; ++j) {
    double ceiling = std::min(plan_[j - 1].limits.speed.value, plan_[j].limits.speed.value);
    const std::uint32_t before = block_of_[j - 1];
    const std::uint32_t after = block_of_[j];
    if (before != after && elements_[j - 1].blend < 0 && elements_[j].blend < 0) {
      const Vec3 step = curvature_at_start(toolpath_, after) - curvature_at_end(toolpath_, before);
      if (!step.isZero(0)) {
        ceiling = std::min(ceiling, crossing_speed(step, axes_.jerk, settings_.period).value);
      }
    }
    ceiling_[j] = ceiling;
  }
  apply_lookahead_horizon(plan_, block_of_, settings_.lookahead, ceiling_);
  ceiling_.front() = ceiling_.back() = 0;
}

bool StretchRunner::is_level(const Blend& blend) const {
  return settings_.reading == EssidReading::strict || blend.turn > level_turn;
}

void StretchRunner::hold_level_blends() {
  level_.clear();
  constexpr double none = 1e-12;  // [mm/s2, mm/s3]: both ends of a blend get the same speed
  for (std::uint32_t e = 0; e < plan_.size(); ++e) {
    if (elements_[e].blend >= 0 && is_level(blends_[static_cast<std::size_t>(elements_[e].blend)])) {
      plan_[e].limits.acceleration.value = plan_[e].limits.jerk.value = none;
      if (level_.empty() || level_.back() < e) {
        level_.push_back(e);
      }
      level_.push_back(e + 1);
    }
  }
}

}  // namespace feedscope
