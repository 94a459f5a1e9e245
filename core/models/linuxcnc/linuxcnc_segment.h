#pragma once

#include <cstdint>

#include "core/limits/cause.h"
#include "core/models/linuxcnc/linuxcnc_settings.h"

namespace feedscope {

/// Share of the acceleration that arcs may use across the path, sqrt(3)/2: half of it is left along the path.
inline constexpr double linuxcnc_across_share = 0.86602540378443864676;

/// End of a segment: at rest, at rest without its neighbours' wait (G61), overlapping with the next, or
/// tangential at some speed.
enum class LinuxCncEnd : std::uint8_t { stop, exact, parabolic, tangent };

/// Course of a segment: a straight lead, then a line's rest or an arc about `center` from `spoke`.
struct LinuxCncCourse {
  bool is_arc = false;
  Vec3 start = Vec3::Zero();      ///< [mm]
  Vec3 direction = Vec3::Zero();  ///< of a line or a lead, unit
  double lead = 0;                ///< straight part before an arc [mm]
  Vec3 center = Vec3::Zero();     ///< [mm]
  Vec3 spoke = Vec3::Zero();      ///< unit, from the centre to the arc's start
  Vec3 normal = Vec3::Zero();     ///< unit; the arc turns counter-clockwise about it
  double radius = 0;              ///< at its start [mm]
  double angle = 0;               ///< > 0 [rad]
  double spiral = 0;              ///< radius at its end less that at its start [mm]
  double height = 0;              ///< along the normal from start to end [mm]
  double length = 0;              ///< of all of it [mm]

  static LinuxCncCourse line(const Vec3& from, const Vec3& to);
  Vec3 at(double s) const;       ///< [mm]
  Vec3 tangent(double s) const;  ///< unit
  /// Unit tangent of an arc across its radius, without the climb of a helix.
  Vec3 flat_tangent(double s) const;
  double arc_length() const;  ///< of the arc alone, from its shape [mm]
  /// Radius for the acceleration across the path, least along the arc [mm].
  double effective_radius() const;
  /// Shortens it by `way` [mm] or, for an arc, by `turn` [rad].
  void cut_end(double way, double turn);
  void cut_start(double way, double turn);
};

/// Meeting place of two segments before the planner rounds it.
struct LinuxCncJoint {
  std::uint32_t block = 0;    ///< the block that ends there
  Vec3 point = Vec3::Zero();  ///< [mm]
  double turn = 0;            ///< [rad]
};

/// A segment in the queue of the planner; symbols as in README.md.
struct LinuxCncSegment {
  LinuxCncCourse course;
  std::uint32_t block = 0;  ///< of the programmed path
  bool rapid = false;
  bool is_blend = false;
  LinuxCncJoint joint;                       ///< of a blend: the joint that it rounds
  double length = 0;                         ///< l [mm]
  double nominal_length = 0;                 ///< l0, as it was added [mm]
  double requested = 0;                      ///< v_r [mm/s]
  double largest = 0;                        ///< v_m [mm/s]
  double acceleration = 0;                   ///< a [mm/s2]
  double final_speed = 0;                    ///< v_f [mm/s]
  bool turns = false;                        ///< of rotary axes: no blend arc on it
  std::int8_t acceleration_axis = -1;        ///< sets a; -1: several
  Cause speed_cause;                         ///< of the lower of v_r and v_m
  Cause final_cause{CauseKind::exact_stop};  ///< of v_f
  double tolerance = 0;                      ///< P [mm]
  LinuxCncEnd end = LinuxCncEnd::parabolic;
  bool finalised = false;
  bool blends_before = false;  ///< blend_prev
  double kink_speed = -1;      ///< at its end; < 0: none [mm/s]
  double kink_share_next = 0;  ///< reductions of the acceleration
  double kink_share_before = 0;
  double tangential_ratio = 0.5;  ///< rho
  bool at_peak = false;
  bool waits_for_spindle = false;

  bool active = false;
  double progress = 0;  ///< [mm]
  double speed = 0;     ///< [mm/s]
  bool ramps = false;   ///< short: one even ramp to its final speed
  bool splitting = false;
  double split_time = 0;   ///< [s]
  double split_speed = 0;  ///< [mm/s]
  bool brakes_finally = false;
  bool overlaps = false;    ///< with the next one
  bool in_overlap = false;  ///< is the later one of an overlap

  double rest() const { return length - progress; }
  /// a_all: acceleration left by joints. `only_in_overlap`: the planner of master halves it only in overlaps.
  double reduced_acceleration(bool only_in_overlap = false) const;
  /// a_t: its part along the path.
  double along_acceleration(bool only_in_overlap = false) const;
  /// Sets the final limits, when its end is known.
  void limit_arc();
  void finalise(double period);
  /// Lowers v_m to at most `speed` [mm/s].
  void lower_largest(double speed, Cause by);
  /// Target speed.
  double target(const LinuxCncSettings& settings) const;
  /// Cause of the target speed.
  Cause cause(const LinuxCncSettings& settings) const;
};

}  // namespace feedscope
