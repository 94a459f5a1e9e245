#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace feedscope {

/// How far one limit of every axis is kept.
///
/// The parts of an acceleration are v' along the path and v^2 k across it; those of a jerk v'' along the path
/// and v^3 k^2, what turning at constant speed takes along it. The third part of a jerk, 3 v v' k across the
/// path, is bounded only where the whole is.
struct KeptLimit {
  enum class Of : std::uint8_t { nothing, parts, whole };
  Of of = Of::nothing;
  double factor = 1;  ///< at most this many times the limit

  bool operator==(const KeptLimit&) const = default;
};

/// What is kept of every axis on one kind of place of the path, jumps (see Continuity) omitted.
struct KeptLimits {
  KeptLimit velocity;
  KeptLimit acceleration;
  KeptLimit jerk;  ///< on corner blends against AxisLimits::blend_jerk where `of_blend_jerk`
  bool of_blend_jerk = false;
};

/// What has no jumps along the path, everything before it included; but for junctions within tangent_angle,
/// where the direction of the motion jumps in models that meet tangent ends.
enum class Continuity : std::uint8_t { position, speed, acceleration };

/// Which kinds of blocks the source of a model covers; the rest keeps to shared rules.
enum class Covered : std::uint8_t { lines, arcs, both };

/// What a model promises with given settings; the contract tests hold it to that.
struct Guarantees {
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  Covered covered = Covered::both;
  KeptLimits lines;
  KeptLimits arcs;       ///< programmed arcs and helices
  KeptLimits blends;     ///< corner blends; meaningless where there are none
  KeptLimits curves;     ///< smooth curves of a compressor; meaningless where there are none
  bool smooths = false;  ///< dense short blocks are smoothed where the program or a setting asks for it
  /// Smooth curves are elements of its path, in the place of dense blocks and of curves of the program.
  bool lays_curves = false;

  /// Largest speed as a multiple of the programmed feed, for a rapid of the axes' speed along it.
  double feed = 1;
  /// The feed that counts is the largest between two standstills: smoothing mixes those of neighbours.
  bool feed_of_run = false;

  /// Largest distance of a programmed corner from the executed path as a multiple of the contour tolerance;
  /// 0: the programmed path is followed exactly.
  double contour = 0;
  /// The end of every block that goes on tangentially is met exactly.
  bool meets_tangent_ends = true;

  bool rapids_of_axes = true;    ///< rapids run at the axes' speed; else at a speed of the control's own
  bool arcs_are_chords = false;  ///< arcs are run as lines; one shorter than a chord as a single one
  /// Programmed points are rounded: to whole steps of the axes, and to numbers of 32 bits.
  bool rounds_places = false;
  /// What comes behind a full stop is run as if the program began there.
  bool begins_again_at_stops = true;

  /// Where the program asks for BRISK, jerk along the path is not bounded: the acceleration changes within
  /// one interpolation period. false: ramps are as without it.
  bool follows_brisk = false;
  /// Joins short blocks where the program or the machine asks for it.
  bool follows_compaction = false;
  /// Tolerances of the program count, by settings of the model's own in place of the common one.
  bool own_tolerances = false;

  /// Else the acceleration jumps, and the largest jerk has no value.
  bool limits_jerk = true;
  Continuity continuity = Continuity::speed;
  bool stops_at_line_corners = false;  ///< of two lines
  bool stops_at_arc_corners = false;   ///< that touch an arc
  bool stops_at_reversals = true;
  bool stops_at_rapids = true;  ///< before and after every one
  /// Ramps along blocks in which rotary axes turn stay within their acceleration and jerk, but for the share
  /// of a place where blocks meet.
  bool holds_rotary_ramps = false;
  /// Largest velocity of any axis of the machine, linear or rotary, where rotary axes turn, as a multiple of
  /// its limit; of X, Y and Z where tool length and part zero are known.
  double turning_velocity = unbounded;
  bool turning_rapids_only = false;  ///< of rapids alone
};

/// All three limits of every axis kept in whole.
KeptLimits all_kept();
/// Velocity in whole, of acceleration and jerk each part for itself: the static limits of arcs
/// (segment_limits.h).
KeptLimits static_arc_limits();

/// As sentences for people, one a fact, in a fixed order.
std::vector<Message> sentences(const Guarantees& guarantees);

}  // namespace feedscope
