#pragma once

#include "core/blend/blended_path.h"
#include "core/limits/axis_share.h"
#include "core/limits/cause.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// A speed ceiling [mm/s] and what sets it.
struct SpeedBound {
  double value = 0;
  Cause cause;

  /// Takes `other` where it is lower.
  void lower(double other, Cause by) {
    if (other < value) {
      value = other;
      cause = by;
    }
  }
};

/// How fast a part of the path can be run, and how fast its speed may change.
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

/// Per axis the largest part of the unit tangent, and of the unit normal, anywhere on an arc or helix.
struct ArcExtremes {
  Vec3 tangent;
  Vec3 normal;
  explicit ArcExtremes(const Arc& arc);
};

/// Highest speed at which no axis exceeds its `velocity` anywhere on segment `i`, a line or an arc [mm/s].
AxisBound axis_speed(const Toolpath& toolpath, std::size_t i, const Vec3& velocity);

/// The cause of a segment's feed: the program, or the cutting feed of Segment::feed_axis.
Cause feed_cause(const Segment& segment);

/// Programmed feed of segment `i`; for a rapid, and where no feed is programmed, the axes' speed along it;
/// 0 for a dwell.
SpeedBound programmed_speed(const Toolpath& toolpath, std::size_t i, const Vec3& velocity);

/// programmed_speed(), or what the machine's rotary axes allow along the segment where that is less
/// (Toolpath::segment_turns): the ceiling that a motion along it starts from [mm/s].
SpeedBound feed_ceiling(const Toolpath& toolpath, std::size_t i, const Vec3& velocity);

/// What a limit of a turn is as the cause of a speed.
Cause cause_of(const TurnLimit& limit);
/// What rotary axes allow where segment `i` meets the next one (Toolpath::turn_joints) [mm/s]; infinite where
/// none changes its slope.
SpeedBound turn_ceiling(const Toolpath& toolpath, std::size_t i);
/// Of a stop where segment `i` ends: that of a joint that makes the tip stop there, else exact_stop.
Cause stop_cause(const Toolpath& toolpath, std::size_t i);
/// The ceiling that the corner between segment `i` and the next one starts from: feed_ceiling() of both, and
/// turn_ceiling() [mm/s].
SpeedBound corner_ceiling(const Toolpath& toolpath, std::size_t i, const Vec3& velocity);

/// The same on a part of the segment (Toolpath::turn_parts); null: on all of it.
SpeedBound feed_ceiling(const Toolpath& toolpath, std::size_t i, const Vec3& velocity, const TurnPart* part);

/// Feed that the axes of the machine allow on the part while rotary axes turn [mm/s]; infinite where none
/// does.
SpeedBound turning_ceiling(const Toolpath& toolpath, std::size_t i, const TurnPart* part);

/// Calls use(part, from, to) for the parts of segment `i` between `from` and `to` from its start [mm], in
/// order: once, with null, where its limits are the same along all of it.
template <typename Use>
void for_turn_parts(const Toolpath& toolpath, std::size_t i, double from, double to, const Use& use) {
  constexpr double least = 1e-9;  // a shorter one goes with the next [mm]
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

/// feed_ceiling() of the part of a segment that an element is, on one in a corner corner_ceiling() [mm/s].
SpeedBound element_ceiling(const BlendedPath& path, std::size_t element, const Vec3& velocity);

/// The part of a segment that an element runs on; null where its limits are those of the whole segment.
const TurnPart* turn_part(const BlendedPath& path, std::size_t element);

/// feed_ceiling() of a span of a smooth curve, the lowest of the blocks along it.
SpeedBound programmed_speed_of_span(const BlendedPath& path, std::size_t element, const Vec3& velocity);

/// Static limits of segment `i` (a line or an arc), least along the segment.
///
/// Line: programmed feed and limit_j / |d_j|. Arc or helix of curvature k (Tapie 2007, section 4;
/// models/tapie/README.md): besides, the radial acceleration v^2 k |n_j| <= A_j and the jerk v^3 k^2 |t_j| <=
/// J_j of running round at constant speed.
///
/// `part`: of a part of it; null: least along all of it.
MotionLimits segment_limits(const Toolpath& toolpath, std::size_t i, const AxisVectors& axes,
                            const TurnPart* part = nullptr);

/// `limits` whose ramps the rotary axes allow that turn along the segments from `first` to `last`, of a curve
/// that stands for parts of them (Toolpath::segment_turns).
MotionLimits with_turns(MotionLimits limits, const Toolpath& toolpath, std::size_t first, std::size_t last);
/// The same of segment `i` by the joints at its ends that shape its course (Toolpath::turn_joints), in motion
/// from standstill to standstill over the segments [first, last): where the tip stops no joint rounds
/// anything.
MotionLimits with_joints(MotionLimits limits, const Toolpath& toolpath, std::size_t i, std::size_t first,
                         std::size_t last);
/// Both of a curve of `length` in the corner behind segment `i`, which it leaves by `transition` before its
/// end [mm]: the axes turn there as along the way that the curve replaces, which is longer.
MotionLimits with_turns_in_corner(MotionLimits limits, const Toolpath& toolpath, std::size_t i,
                                  std::size_t first, std::size_t last, double transition, double length);

/// How fast the curve in a corner, an element of `path`, lets the tip go for the axes of the machine to keep
/// their velocity along it.
SpeedBound turning_speed_in_corner(const BlendedPath& path, std::size_t element);

/// The same for an arc that need not stand in the program, run at `programmed` at most.
MotionLimits arc_limits(const Arc& arc, const SpeedBound& programmed, const AxisVectors& axes);

/// Per axis the largest part of the first three derivatives of the position by path length on a span of a
/// smooth curve, from nine places of it: of the tangent, of the curvature vector [1/mm], and of its
/// derivative [1/mm2].
struct SpanExtremes {
  Vec3 tangent = Vec3::Zero();
  Vec3 bend = Vec3::Zero();
  Vec3 change = Vec3::Zero();
  double curvature = 0;  ///< [1/mm]
  explicit SpanExtremes(const CourseSpan& span);
};

/// The same for a span of a smooth curve. With p1, p2, p3 the derivatives of the position by path length, an
/// axis has the acceleration p2 v^2 + p1 v' and the jerk p3 v^3 + 3 p2 v v' + p1 v''. The speed takes at most
/// `turning_share` of either by its first term, and ramps have what it leaves for their last; the middle
/// term of the jerk is not in it (lower_curve_ceilings() of curve_motion.h).
MotionLimits curve_limits(const SpanExtremes& span, const SpeedBound& programmed, const AxisVectors& axes);

/// Share of an axis' acceleration and jerk that turning along a smooth curve may take. Ours: shares of 0.75
/// to 0.9 differ by 2 % in the time of a finishing program.
inline constexpr double turning_share = 0.75;

/// `limits` where the acceleration along the path may jump, as BRISK of a program asks for: no axis' jerk
/// limits ramps there (the bound names none). An interpolated acceleration changes from one period to the
/// next, so that the jump takes one `interpolation_period` [s]; where the axes' jerk is as fast, it stays.
MotionLimits with_acceleration_jumps(MotionLimits limits, double interpolation_period);

/// Ceiling [mm/s] where the curvature vector jumps by `step` [1/mm] in a tangent junction: the axes must take
/// up v^2 step_j within one interpolation period, v^2 |step_j| <= J_j t_cy. For equal axis jerks this is
/// sqrt(J t_cy / |k1 - k2|) of Tapie 2007 (models/tapie/README.md), signed curvatures included.
SpeedBound crossing_speed(const Vec3& step, const Vec3& jerk, double interpolation_period);

}  // namespace feedscope
