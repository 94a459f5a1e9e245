#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/kinematics/kinematic_chain.h"
#include "core/machine/settings.h"

namespace feedscope {

/// A rotary axis of a machine: its limits, and where it is while all axes stand at zero.
struct RotaryAxis {
  char name = 'A';                ///< A, B or C
  double velocity = 0;            ///< [rad/s]
  double acceleration = 0;        ///< [rad/s2]
  double jerk = 0;                ///< [rad/s3]
  std::optional<double> minimum;  ///< of its travel [rad]; none: without end
  std::optional<double> maximum;
  /// Of any length: seen against it, the tool turns counter-clockwise against the part as the coordinate
  /// grows, whichever of the two the axis turns (ISO 841).
  Vec3 direction = Vec3::UnitZ();
  Vec3 point = Vec3::Zero();  ///< on its line, in machine coordinates [mm]
  bool operator==(const RotaryAxis&) const = default;
};

/// The rotary axes of a machine and which axes carry the part and the tool. Machine coordinates are those of
/// the spindle's gauge point, from which the tool points to -Z while all axes stand at zero.
struct MachineKinematics {
  /// Axes from the part to the tool: those that carry the part, the word "frame", those that carry the tool:
  /// "C A Y frame X Z".
  std::string chain;
  std::vector<RotaryAxis> rotary;     ///< by name
  std::optional<double> tool_length;  ///< from the gauge point to the tip [mm]; none: not known
  bool empty() const { return rotary.empty(); }
  /// Null if there is none.
  const RotaryAxis* find(char axis) const;
  bool operator==(const MachineKinematics&) const = default;
};

/// The chain with the axes where the kinematics have them, linear ones along X, Y and Z. Throws InputError
/// for a text that is no chain and as KinematicChain: it names the axis and what is wrong.
KinematicChain chain_of(const MachineKinematics& kinematics);

/// Names that rotary axes can have.
inline constexpr std::string_view rotary_names = "ABC";
/// Names of all axes that machines can have, for KEY=VALUE.
inline constexpr std::string_view possible_axes = "XYZABC";
/// Keys of a rotary axis for --set and machine files: velocity (rev/min), acceleration (rev/s2), jerk
/// (rev/s3), and the optional minimum and maximum (deg) of its travel.
const std::vector<SettingSpec>& rotary_axis_specs();
/// Value in the unit of rotary_axis_specs(), an empty text if there is none; `i` is a place in that list.
SettingValue rotary_value(const RotaryAxis& axis, std::size_t i);
/// Sets it; an empty text takes an optional value back. Throws InputError as check_setting().
void set_rotary_value(RotaryAxis& axis, std::size_t i, const SettingValue& value);

/// The least time over `way` from rest to rest with these limits, all > 0, phases of constant jerk and
/// symmetric ramps (core/models/README.md), in the units of the way and s.
double rest_to_rest_time(double way, double velocity, double acceleration, double jerk);
/// Where such a motion is at one instant.
struct RestToRestPlace {
  double way = 0;       ///< from its start
  double velocity = 0;  ///< along the way, >= 0
  double acceleration = 0;
  double jerk = 0;
};
/// Of the motion that takes rest_to_rest_time(), `time` from its start, at rest before and behind it [s];
/// `way` > 0.
RestToRestPlace rest_to_rest_at(double time, double way, double velocity, double acceleration, double jerk);
/// The largest velocity, acceleration and jerk of that motion, and its way.
RestToRestPlace rest_to_rest_peaks(double way, double velocity, double acceleration, double jerk);
/// Time of a turn by `angle` [rad] from rest to rest: jerk-limited, at most at `feed` [rad/s], 0: as fast as
/// the axis may (core/models/README.md) [s].
double turning_time(const RotaryAxis& axis, double angle, double feed = 0);

}  // namespace feedscope
