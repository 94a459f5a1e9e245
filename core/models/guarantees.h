#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace feedscope {

/// Extent to which one limit of every axis is kept.
///
/// The parts of an acceleration are v' along the path and v^2 k across it; those of a jerk v'' along the path
/// and v^3 k^2, along it by turning at constant speed. The third part of a jerk, 3 v v' k across the
/// path, is bounded only if the whole jerk is.
struct KeptLimit {
  enum class Of : std::uint8_t { nothing, parts, whole };
  Of of = Of::nothing;
  double factor = 1;  ///< at most this many times the limit

  bool operator==(const KeptLimit&) const = default;
};

/// Limits kept by every axis on one kind of place of the path, without jumps (see Continuity).
struct KeptLimits {
  KeptLimit velocity;
  KeptLimit acceleration;
  KeptLimit jerk;  ///< on corner blends against AxisLimits::blend_jerk where `of_blend_jerk`
  bool of_blend_jerk = false;
};

/// Highest quantity without jumps along the path, including all lower ones. Exception: junctions within
/// tangent_angle, where the direction of the motion jumps in models that meet tangent ends.
enum class Continuity : std::uint8_t { position, speed, acceleration };

/// Kinds of blocks covered by the source of a model; the others follow shared rules.
enum class Covered : std::uint8_t { lines, arcs, both };

/// Promises of a model with given settings, which the contract tests check.
struct Guarantees {
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  Covered covered = Covered::both;
  KeptLimits lines;
  KeptLimits arcs;       ///< programmed arcs and helices
  KeptLimits blends;     ///< corner blends; meaningless where there are none
  KeptLimits curves;     ///< smooth curves of a compressor; meaningless where there are none
  bool smooths = false;  ///< smooths dense short blocks where the program or a setting enables it
  /// Smooth curves are elements of its path, in place of dense blocks and of curves of the program.
  bool lays_curves = false;

  /// Largest speed as a multiple of the programmed feed, for a rapid of the axes' speed along it.
  double feed = 1;
  /// `feed` refers to the largest feed between two standstills, because smoothing mixes those of neighbours.
  bool feed_of_run = false;

  /// Largest distance of a programmed corner from the executed path as a multiple of the contour tolerance;
  /// 0: the programmed path is followed exactly.
  double contour = 0;
  /// Ends of blocks that continue tangentially are met exactly.
  bool meets_tangent_ends = true;

  bool rapids_of_axes = true;    ///< rapids run at the axes' speed; else at the control's own speed
  bool arcs_are_chords = false;  ///< arcs are run as lines; an arc shorter than a chord is one line
  /// Programmed points are rounded: to whole steps of the axes, and to numbers of 32 bits.
  bool rounds_places = false;
  /// Motion after a full stop is the same as if the program began there.
  bool begins_again_at_stops = true;

  /// In BRISK, jerk along the path is not bounded: the acceleration changes within one interpolation period.
  /// false: ramps are the same as without it.
  bool follows_brisk = false;
  /// Joins short blocks where the program or the machine enables it.
  bool follows_compaction = false;
  /// Tolerances of the program apply, by the model's own settings instead of the common one.
  bool own_tolerances = false;

  /// If false, the acceleration jumps, and the largest jerk has no value.
  bool limits_jerk = true;
  Continuity continuity = Continuity::speed;
  bool stops_at_line_corners = false;  ///< of two lines
  bool stops_at_arc_corners = false;   ///< that touch an arc
  bool stops_at_reversals = true;
  bool stops_at_rapids = true;  ///< before and after each
  /// Ramps along blocks in which rotary axes turn stay within their acceleration and jerk, except for the
  /// share of a place where blocks meet.
  bool holds_rotary_ramps = false;
  /// Largest velocity of any axis of the machine, linear or rotary, where rotary axes turn, as a multiple of
  /// its limit; for X, Y and Z only where tool length and part zero are known.
  double turning_velocity = unbounded;
  bool turning_rapids_only = false;  ///< of rapids only
};

/// All three limits of every axis kept as a whole.
KeptLimits all_kept();
/// Velocity as a whole, each part of acceleration and jerk separately: the static limits of arcs
/// (segment_limits.h).
KeptLimits static_arc_limits();

/// Sentences for people, one for each fact, in a fixed order.
std::vector<Message> sentences(const Guarantees& guarantees);

}  // namespace feedscope
