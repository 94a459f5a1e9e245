#pragma once

// Room `limits`: how fast an element may be run. Ceilings of speed, acceleration and jerk along a line, arc
// or blend from the limits of the axes; cause.h names what sets a ceiling, formula.h writes it out for
// explanations.

#include "core/blend/blended_path.h"
#include "core/limits/axis_share.h"
#include "core/limits/cause.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// A speed ceiling [mm/s] and its cause.
struct SpeedBound {
  double value = 0;
  Cause cause;

  /// Takes `other` if it is lower.
  void lower(double other, Cause by) {
    if (other < value) {
      value = other;
      cause = by;
    }
  }
};

/// Largest speed on a part of the path, and limits for changing it.
struct MotionLimits {
  SpeedBound speed;        ///< [mm/s]
  AxisBound acceleration;  ///< along the path [mm/s2]
  AxisBound jerk;          ///< along the path [mm/s3]
};

/// Every axis' limits as vectors [mm/s, mm/s2, mm/s3].
struct AxisVectors {
  Vec3 velocity;
  Vec3 acceleration;
  Vec3 jerk;
  Vec3 blend_jerk;
  explicit AxisVectors(const Machine& machine);
};

/// Largest component of the unit tangent and of the unit normal on an arc or helix, per axis.
struct ArcExtremes {
  Vec3 tangent;
  Vec3 normal;
  explicit ArcExtremes(const Arc& arc);
};

/// Largest speed at which all axes stay within `velocity` anywhere on segment `i`, a line or an arc [mm/s].
AxisBound axis_speed(const Toolpath& toolpath, std::size_t i, const Vec3& velocity);

/// Cause of a segment's feed: the program, or the cutting feed of Segment::feed_axis.
Cause feed_cause(const Segment& segment);

/// Programmed feed of segment `i`; the axes' speed along it for a rapid or without a programmed feed; 0 for a
/// dwell.
SpeedBound programmed_speed(const Toolpath& toolpath, std::size_t i, const Vec3& velocity);

/// programmed_speed(), or the speed that the machine's rotary axes allow along the segment if lower
/// (Toolpath::segment_turns): initial ceiling of a motion along it [mm/s].
SpeedBound feed_ceiling(const Toolpath& toolpath, std::size_t i, const Vec3& velocity);

/// Cause of a speed limited by a turn.
Cause cause_of(const TurnLimit& limit);
/// Speed that rotary axes allow at the junction of segment `i` with the next one (Toolpath::turn_joints)
/// [mm/s]; infinite if none changes its slope.
SpeedBound turn_ceiling(const Toolpath& toolpath, std::size_t i);
/// Cause of a stop at the end of segment `i`: that of a joint at which the tip stops, else exact_stop.
Cause stop_cause(const Toolpath& toolpath, std::size_t i);
/// Initial ceiling of the corner between segment `i` and the next one: the lowest of feed_ceiling() of both,
/// and turn_ceiling() [mm/s].
SpeedBound corner_ceiling(const Toolpath& toolpath, std::size_t i, const Vec3& velocity);

/// Ceiling on a part of the segment (Toolpath::turn_parts); null: on all of it.
SpeedBound feed_ceiling(const Toolpath& toolpath, std::size_t i, const Vec3& velocity, const TurnPart* part);

/// Feed that the axes of the machine allow on the part while rotary axes turn [mm/s]; infinite if none does.
SpeedBound turning_ceiling(const Toolpath& toolpath, std::size_t i, const TurnPart* part);

/// Calls use(part, from, to) for the parts of segment `i` between `from` and `to` from its start [mm], in
/// order; once, with null, if its limits are the same everywhere.
template <typename Use>
void for_turn_parts(const Toolpath& toolpath, std::size_t i, double from, double to, const Use& use) {
  constexpr double least = 1e-9;  // shorter ones are merged with the next [mm]
  for (const TurnPart& part : toolpath.turn_parts_of(i)) {
    const double end = part.end > to - least ? to : part.end;
    if (end > from + least) {
      use(&part, from, end);
      from = end;
    }
  }
  if (from < to) {
    use(static_cast<const TurnPart*>(nullptr), from, to);
  }
}

/// feed_ceiling() of the part of a segment for an element, corner_ceiling() in a corner [mm/s].
SpeedBound element_ceiling(const BlendedPath& path, std::size_t element, const Vec3& velocity);

/// Part of a segment for an element; null if its limits are those of the whole segment.
const TurnPart* turn_part(const BlendedPath& path, std::size_t element);

/// feed_ceiling() of a span of a smooth curve, the lowest of the blocks along it.
SpeedBound programmed_speed_of_span(const BlendedPath& path, std::size_t element, const Vec3& velocity);

/// Static limits of segment `i` (a line or an arc), smallest along the segment.
///
/// Line: programmed feed and limit_j / |d_j|. Arc or helix of curvature k (Tapie 2007, section 4;
/// models/tapie/README.md): additionally the radial acceleration v^2 k |n_j| <= A_j and the jerk v^3 k^2
/// |t_j| <= J_j at constant speed.
///
/// `part`: limits on that part; null: smallest along all of it.
MotionLimits segment_limits(const Toolpath& toolpath, std::size_t i, const AxisVectors& axes,
                            const TurnPart* part = nullptr);

/// `limits` with ramps limited by the rotary axes that turn along the segments from `first` to `last`, for a
/// curve that replaces parts of them (Toolpath::segment_turns).
MotionLimits with_turns(MotionLimits limits, const Toolpath& toolpath, std::size_t first, std::size_t last);
/// `limits` of segment `i` reduced by the joints at its ends (Toolpath::turn_joints), in motion from
/// standstill to standstill over the segments [first, last): where the tip stops no joint rounds anything.
MotionLimits with_joints(MotionLimits limits, const Toolpath& toolpath, std::size_t i, std::size_t first,
                         std::size_t last);
/// with_turns() and with_joints() for a curve of `length` in the corner after segment `i`, which it leaves
/// `transition` before its end [mm]: the axes turn as along the replaced path, which is longer.
MotionLimits with_turns_in_corner(MotionLimits limits, const Toolpath& toolpath, std::size_t i,
                                  std::size_t first, std::size_t last, double transition, double length);

/// Speed of the tip on the curve in a corner, an element of `path`, at which the axes of the machine stay
/// within their velocity.
SpeedBound turning_speed_in_corner(const BlendedPath& path, std::size_t element);

/// Limits of an arc that need not be in the program, run at most at `programmed`.
MotionLimits arc_limits(const Arc& arc, const SpeedBound& programmed, const AxisVectors& axes);

/// Largest components, per axis, of the first three derivatives of the position by path length on a span of a
/// smooth curve, from nine of its places: of the tangent, of the curvature vector [1/mm], and of its
/// derivative [1/mm2].
struct SpanExtremes {
  Vec3 tangent = Vec3::Zero();
  Vec3 bend = Vec3::Zero();
  Vec3 change = Vec3::Zero();
  double curvature = 0;  ///< [1/mm]
  explicit SpanExtremes(const CourseSpan& span);
};

/// Limits of a span of a smooth curve. With p1, p2, p3 the derivatives of the position by path length, an
/// axis has the acceleration p2 v^2 + p1 v' and the jerk p3 v^3 + 3 p2 v v' + p1 v''. The speed takes at most
/// `turning_share` of either by its first term, and ramps get the rest for the last term; the middle term of
/// the jerk is not included (lower_curve_ceilings() of curve_motion.h).
MotionLimits curve_limits(const SpanExtremes& span, const SpeedBound& programmed, const AxisVectors& axes);

/// Share of an axis' acceleration and jerk that turning along a smooth curve may take. Our choice: shares of
/// 0.75 to 0.9 differ by 2 % in the time of a finishing program.
inline constexpr double turning_share = 0.75;

/// `limits` if the acceleration along the path may jump, as BRISK in a program requests: no axis' jerk limits
/// ramps there (the bound has no axis). An interpolated acceleration changes from one period to the next, so
/// the jump takes one `interpolation_period` [s]; if the axes' jerk is as fast, it remains.
MotionLimits with_acceleration_jumps(MotionLimits limits, double interpolation_period);

/// Ceiling [mm/s] where the curvature vector jumps by `step` [1/mm] at a tangent junction: the axes must take
/// up v^2 step_j within one interpolation period, v^2 |step_j| <= J_j t_cy. For equal axis jerks this is
/// sqrt(J t_cy / |k1 - k2|) of Tapie 2007 (models/tapie/README.md), including signed curvatures.
SpeedBound crossing_speed(const Vec3& step, const Vec3& jerk, double interpolation_period);

}  // namespace feedscope
