#include "core/limits/segment_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/blend/junction.h"
#include "core/toolpath/joint_shape.h"
#include "core/toolpath/turn_ceiling.h"

namespace feedscope {
namespace {

/// Largest |offset + p cos(a) + q sin(a)| for a in [0, sweep].
double largest_component(double offset, double p, double q, double sweep) {
  const auto value = [&](double a) { return std::abs(offset + p * std::cos(a) + q * std::sin(a)); };
  double largest = std::max(value(0), value(sweep));
  const double crest = std::atan2(q, p);
  const double first = std::ceil(-crest / units::pi);
  for (double n = first; crest + n * units::pi <= sweep && n < first + 2; ++n) {
    largest = std::max(largest, value(crest + n * units::pi));
  }
  return largest;
}

Cause by_axis(CauseKind kind, AxisBound bound) {
  return {kind, bound.axis};
}

const Arc& arc_of(const Toolpath& toolpath, std::size_t i) {
  return toolpath.arc_of(toolpath.segments[i]);
}

Vec3 direction_of(const Toolpath& toolpath, std::size_t i) {
  return (toolpath.segments[i].end - toolpath.start_of(i)) / toolpath.segments[i].length;
}

}  // namespace

ArcExtremes::ArcExtremes(const Arc& arc) {
  const double along = arc.radius / arc.length_per_radian();
  const Vec3 rise = arc.rise / arc.length_per_radian();
  for (int j = 0; j < 3; ++j) {
    tangent[j] = largest_component(rise[j], along * arc.y[j], -along * arc.x[j], arc.sweep);
    normal[j] = largest_component(0, arc.x[j], arc.y[j], arc.sweep);
  }
}

namespace {

AxisBound lower_of(const AxisBound& a, const AxisBound& b) {
  return b.value < a.value ? b : a;
}

void lower_ramp(MotionLimits& limits, const TurnRamp& ramp) {
  limits.acceleration =
      lower_of(limits.acceleration, {ramp.acceleration, ramp.acceleration_axis, ramp.acceleration_by_jerk});
  limits.jerk = lower_of(limits.jerk, {ramp.jerk, ramp.jerk_axis});
}

}  // namespace

AxisVectors::AxisVectors(const Machine& machine)
    : velocity(axis_limit_vector(machine, &AxisLimits::velocity)),
      acceleration(axis_limit_vector(machine, &AxisLimits::acceleration)),
      jerk(axis_limit_vector(machine, &AxisLimits::jerk)),
      blend_jerk(axis_limit_vector(machine, &AxisLimits::blend_jerk)) {}

AxisBound axis_speed(const Toolpath& toolpath, std::size_t i, const Vec3& velocity) {
  const bool arc = toolpath.segments[i].kind == SegmentKind::arc;
  return axis_share(velocity, arc ? ArcExtremes(arc_of(toolpath, i)).tangent : direction_of(toolpath, i));
}

Cause feed_cause(const Segment& segment) {
  return {segment.feed_axis < 0 ? CauseKind::programmed_feed : CauseKind::axis_velocity, segment.feed_axis};
}

SpeedBound programmed_speed(const Toolpath& toolpath, std::size_t i, const Vec3& velocity) {
  const Segment& segment = toolpath.segments[i];
  if (segment.kind == SegmentKind::dwell) {
    return {0, {CauseKind::dwell}};
  }
  if (segment.feed > 0 && !segment.rapid) {
    return {segment.feed, feed_cause(segment)};
  }
  const AxisBound bound = axis_speed(toolpath, i, velocity);
  return {bound.value, {segment.rapid ? CauseKind::rapid : CauseKind::axis_velocity, bound.axis}};
}

SpeedBound feed_ceiling(const Toolpath& toolpath, std::size_t i, const Vec3& velocity) {
  return feed_ceiling(toolpath, i, velocity, nullptr);
}

SpeedBound feed_ceiling(const Toolpath& toolpath, std::size_t i, const Vec3& velocity, const TurnPart* part) {
  SpeedBound bound = programmed_speed(toolpath, i, velocity);
  const SpeedBound turning = turning_ceiling(toolpath, i, part);
  bound.lower(turning.value, turning.cause);
  const Segment& segment = toolpath.segments[i];
  const bool is_block = segment.kind != SegmentKind::dwell && !segment.rapid && !segment.on_curve;
  if (toolpath.block_time > 0 && is_block) {
    bound.lower(segment.length / toolpath.block_time, {CauseKind::block_time});
  }
  return bound;
}

SpeedBound turning_ceiling(const Toolpath& toolpath, std::size_t i, const TurnPart* part) {
  SpeedBound bound{std::numeric_limits<double>::infinity(), {}};
  const auto lower_by = [&](const TurnLimit& limit) { bound.lower(limit.speed, cause_of(limit)); };
  if (part != nullptr) {
    lower_by(part->limit);
  } else if (const SegmentTurn* turn = toolpath.segment_turn(i)) {
    lower_by(turn->limit);
  } else {
    for (const TurnPart& of : toolpath.turn_parts_of(i)) {
      lower_by(of.limit);
    }
  }
  return bound;
}

SpeedBound turn_ceiling(const Toolpath& toolpath, std::size_t i) {
  const TurnJoint* joint = toolpath.turn_joint(i);
  return joint != nullptr ? SpeedBound{joint->limit.speed, cause_of(joint->limit)}
                          : SpeedBound{std::numeric_limits<double>::infinity(), {}};
}

Cause stop_cause(const Toolpath& toolpath, std::size_t i) {
  const TurnJoint* joint = toolpath.turn_joints.empty() ? nullptr : toolpath.turn_joint(i);
  return joint != nullptr && joint->stops ? cause_of(joint->limit) : Cause{CauseKind::exact_stop};
}

SpeedBound corner_ceiling(const Toolpath& toolpath, std::size_t i, const Vec3& velocity) {
  const std::span<const TurnPart> before = toolpath.turn_parts_of(i);
  const std::span<const TurnPart> after = toolpath.turn_parts_of(i + 1);
  SpeedBound bound = feed_ceiling(toolpath, i, velocity, before.empty() ? nullptr : &before.back());
  for (const SpeedBound& other :
       {feed_ceiling(toolpath, i + 1, velocity, after.empty() ? nullptr : &after.front()),
        turn_ceiling(toolpath, i)}) {
    bound.lower(other.value, other.cause);
  }
  return bound;
}

Cause cause_of(const TurnLimit& limit) {
  switch (limit.by) {
    case TurnLimit::By::velocity:
      return {CauseKind::axis_velocity, limit.axis};
    case TurnLimit::By::jerk:
      return {CauseKind::axis_jerk, limit.axis};
    case TurnLimit::By::acceleration:
    case TurnLimit::By::jump:
      break;
  }
  return {CauseKind::axis_acceleration, limit.axis};
}

SpeedBound element_ceiling(const BlendedPath& path, std::size_t element, const Vec3& velocity) {
  const std::size_t i = path.segment(element);
  return path.in_corner(element) ? corner_ceiling(*path.programmed(), i, velocity)
                                 : feed_ceiling(*path.programmed(), i, velocity, turn_part(path, element));
}

const TurnPart* turn_part(const BlendedPath& path, std::size_t element) {
  const std::span<const TurnPart> parts = path.programmed()->turn_parts_of(path.segment(element));
  if (parts.empty() || path.kind(element) != ElementKind::line || path.is_executed()) {
    return nullptr;
  }
  const double middle = path.line_offset(element) + path.length(element) / 2;
  const auto found = std::ranges::lower_bound(parts, middle, std::less(), &TurnPart::end);
  return found != parts.end() ? &*found : &parts.back();
}

SpeedBound programmed_speed_of_span(const BlendedPath& path, std::size_t element, const Vec3& velocity) {
  const Toolpath& toolpath = *path.programmed();
  const std::size_t first = path.segment(element);
  SpeedBound bound = feed_ceiling(toolpath, first, velocity);
  if (element + 1 == path.size()) {
    return bound;
  }
  std::size_t last = path.segment(element + 1);
  const ElementKind next = path.kind(element + 1);
  if (next != ElementKind::curve && last > first && path.curve(element).end == toolpath.start_of(last)) {
    --last;  // the curve ends with a block
  }
  for (std::size_t i = first + 1; i <= last; ++i) {
    for (const SpeedBound& other : {feed_ceiling(toolpath, i, velocity), turn_ceiling(toolpath, i - 1)}) {
      bound.lower(other.value, other.cause);
    }
  }
  return bound;
}

MotionLimits segment_limits(const Toolpath& toolpath, std::size_t i, const AxisVectors& axes,
                            const TurnPart* part) {
  MotionLimits limits{feed_ceiling(toolpath, i, axes.velocity, part), {}, {}};
  if (toolpath.segments[i].kind == SegmentKind::line) {
    const Vec3 direction = direction_of(toolpath, i);
    const AxisBound velocity = axis_share(axes.velocity, direction);
    limits.speed.lower(velocity.value, by_axis(CauseKind::axis_velocity, velocity));
    limits.acceleration = axis_share(axes.acceleration, direction);
    limits.jerk = axis_share(axes.jerk, direction);
  } else {
    limits = arc_limits(arc_of(toolpath, i), limits.speed, axes);
  }
  if (part != nullptr) {
    lower_ramp(limits, part->ramp);
    return limits;
  }
  return with_turns(limits, toolpath, i, i);
}

MotionLimits with_turns(MotionLimits limits, const Toolpath& toolpath, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i <= last && !toolpath.segment_turns.empty(); ++i) {
    if (const SegmentTurn* turn = toolpath.segment_turn(i)) {
      lower_ramp(limits, turn->ramp);
    }
  }
  return limits;
}

MotionLimits with_joints(MotionLimits limits, const Toolpath& toolpath, std::size_t i, std::size_t first,
                         std::size_t last) {
  if (toolpath.turn_joints.empty()) {
    return limits;
  }
  const double length = toolpath.segments[i].length;
  const auto lower_beside = [&](const TurnJoint* joint, double TurnJoint::*reach) {
    if (joint != nullptr && shapes_segment(joint->*reach, length)) {
      lower_ramp(limits, joint->ramp);
    }
  };
  if (i > first) {
    lower_beside(toolpath.turn_joint(i - 1), &TurnJoint::behind);
  }
  if (i + 1 < last) {
    lower_beside(toolpath.turn_joint(i), &TurnJoint::before);
  }
  return limits;
}

namespace {

/// Calls use(limit, ramp) for the turns on both sides of a corner within `transition` of it [mm].
template <typename Use>
void for_turns_in_corner(const Toolpath& toolpath, std::size_t i, double transition, const Use& use) {
  const double whole = toolpath.segments[i].length;
  const auto on = [&](std::size_t segment, double from, double to) {
    for_turn_parts(toolpath, segment, from, to, [&](const TurnPart* part, double, double) {
      if (part != nullptr) {
        use(part->limit, part->ramp);
      } else if (const SegmentTurn* turn = toolpath.segment_turn(segment)) {
        use(turn->limit, turn->ramp);
      }
    });
  };
  on(i, whole - transition, whole);
  on(i + 1, 0, transition);
}

}  // namespace

MotionLimits with_turns_in_corner(MotionLimits limits, const Toolpath& toolpath, std::size_t i,
                                  std::size_t first, std::size_t last, double transition, double length) {
  if (toolpath.segment_turns.empty() || !(length > 0)) {
    return limits;
  }
  const double faster = std::max(1.0, 2 * transition / length);  // ratio to the replaced path
  const MotionLimits unturned = limits;
  for_turns_in_corner(toolpath, i, transition,
                      [&](const TurnLimit& /*limit*/, const TurnRamp& ramp) { lower_ramp(limits, ramp); });
  limits = with_joints(limits, toolpath, i, first, i + 1);
  limits = with_joints(limits, toolpath, i + 1, i + 1, last);
  if (const TurnJoint* joint = toolpath.turn_joint(i)) {
    lower_ramp(limits, joint->ramp);
  }
  if (limits.acceleration.value < unturned.acceleration.value) {
    limits.acceleration.value /= faster;
  }
  if (limits.jerk.value < unturned.jerk.value) {
    limits.jerk.value /= faster;
  }
  for_turns_in_corner(toolpath, i, transition, [&](const TurnLimit& limit, const TurnRamp& /*ramp*/) {
    limits.speed.lower(limit.speed / faster, cause_of(limit));
  });
  const SpeedBound joint = turn_ceiling(toolpath, i);
  limits.speed.lower(joint.value / faster, joint.cause);
  return limits;
}

SpeedBound turning_speed_in_corner(const BlendedPath& path, std::size_t element) {
  constexpr int least = 4;
  constexpr double step = 0.1;  // of the tip's rotation [rad]
  if (path.base().turn_ceiling == nullptr || !(path.length(element) > 0)) {
    return {std::numeric_limits<double>::infinity(), {}};
  }
  const ElementCurve curve = path.curve(element);
  const double turn = turn_angle(curve.at(0).d1, curve.at(curve.length).d1);
  const int half = least + static_cast<int>(turn / step);
  std::vector<CurvePoint> tips;
  for (int k = 0; k <= 2 * half; ++k) {
    tips.push_back(curve.at(curve.length * k / (2 * half)));
  }
  const TurnLimit limit =
      path.base().turn_ceiling->on_corner(path.base(), path.base_segment_of(element),
                                          path.corner_transition(path.index(element)), tips, curve.length);
  return {limit.speed, cause_of(limit)};
}

MotionLimits arc_limits(const Arc& arc, const SpeedBound& programmed, const AxisVectors& axes) {
  MotionLimits limits{programmed, {}, {}};
  const ArcExtremes extremes(arc);
  const double k = arc.curvature();
  const AxisBound velocity = axis_share(axes.velocity, extremes.tangent);
  const AxisBound radial = axis_share(axes.acceleration, extremes.normal);
  limits.acceleration = axis_share(axes.acceleration, extremes.tangent);
  limits.jerk = axis_share(axes.jerk, extremes.tangent);
  limits.speed.lower(velocity.value, by_axis(CauseKind::axis_velocity, velocity));
  limits.speed.lower(std::sqrt(radial.value / k), by_axis(CauseKind::radial_acceleration, radial));
  limits.speed.lower(std::cbrt(limits.jerk.value / (k * k)), by_axis(CauseKind::radial_jerk, limits.jerk));
  return limits;
}

SpanExtremes::SpanExtremes(const CourseSpan& span) {
  constexpr int places = 9;
  for (int i = 0; i < places; ++i) {
    const CurvePoint at = span.by_share(i / (places - 1.0));
    tangent = tangent.cwiseMax(at.d1.cwiseAbs());
    bend = bend.cwiseMax(at.d2.cwiseAbs());
    change = change.cwiseMax(at.d3.cwiseAbs());
    curvature = std::max(curvature, at.d2.norm());
  }
}

MotionLimits curve_limits(const SpanExtremes& span, const SpeedBound& programmed, const AxisVectors& axes) {
  MotionLimits limits{programmed, {}, {}};
  const AxisBound velocity = axis_share(axes.velocity, span.tangent);
  const AxisBound radial = axis_share(turning_share * axes.acceleration, span.bend);
  const AxisBound turning = axis_share(turning_share * axes.jerk, span.change);
  limits.speed.lower(velocity.value, by_axis(CauseKind::axis_velocity, velocity));
  limits.speed.lower(std::sqrt(radial.value), by_axis(CauseKind::radial_acceleration, radial));
  limits.speed.lower(std::cbrt(turning.value), by_axis(CauseKind::radial_jerk, turning));

  const double v = limits.speed.value;
  limits.acceleration = axis_share(axes.acceleration - v * v * span.bend, span.tangent);
  limits.jerk = axis_share(axes.jerk - v * v * v * span.change, span.tangent);
  return limits;
}

MotionLimits with_acceleration_jumps(MotionLimits limits, double interpolation_period) {
  const double jump = limits.acceleration.value / interpolation_period;
  if (jump > limits.jerk.value) {
    limits.jerk = {jump, -1};
  }
  return limits;
}

SpeedBound crossing_speed(const Vec3& step, const Vec3& jerk, double interpolation_period) {
  const AxisBound bound = axis_share(jerk, step);
  return {std::sqrt(bound.value * interpolation_period), by_axis(CauseKind::curvature_crossing, bound)};
}

}  // namespace feedscope
