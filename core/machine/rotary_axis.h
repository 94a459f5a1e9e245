#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/kinematics/kinematic_chain.h"
#include "core/machine/settings.h"

namespace feedscope {

/// A rotary axis of a machine: its limits, and its position while all axes are at zero.
struct RotaryAxis {
  char name = 'A';                ///< A, B or C
  double velocity = 0;            ///< [rad/s]
  double acceleration = 0;        ///< [rad/s2]
  double jerk = 0;                ///< [rad/s3]
  std::optional<double> minimum;  ///< of its travel [rad]; none: without end
  std::optional<double> maximum;
  /// Of any length. Seen against it, the tool turns counter-clockwise against the part as the coordinate
  /// grows, whether the axis turns tool or part (ISO 841).
  Vec3 direction = Vec3::UnitZ();
  Vec3 point = Vec3::Zero();  ///< on its line, in machine coordinates [mm]
  bool operator==(const RotaryAxis&) const = default;
};

/// Rotary axes of a machine, and the axes that carry part and tool. Machine coordinates are those of the
/// spindle's gauge point, from which the tool points to -Z while all axes are at zero.
struct MachineKinematics {
  /// Axes from the part to the tool: those that carry the part, the word "frame", those that carry the tool:
  /// "C A Y frame X Z".
  std::string chain;
  std::vector<RotaryAxis> rotary;     ///< sorted by name
  std::optional<double> tool_length;  ///< from the gauge point to the tip [mm]; none: unknown
  bool empty() const { return rotary.empty(); }
  /// Null if there is none.
  const RotaryAxis* find(char axis) const;
  bool operator==(const MachineKinematics&) const = default;
};

/// Chain with the axes as the kinematics describe them, linear ones along X, Y and Z. Throws InputError for
/// an invalid chain and as KinematicChain, with axis and problem.
KinematicChain chain_of(const MachineKinematics& kinematics);

/// Possible names of rotary axes.
inline constexpr std::string_view rotary_names = "ABC";
/// Possible names of all axes, for KEY=VALUE.
inline constexpr std::string_view possible_axes = "XYZABC";
/// Keys of a rotary axis for --set and machine files: velocity (rev/min), acceleration (rev/s2), jerk
/// (rev/s3), and the optional minimum and maximum (deg) of its travel.
const std::vector<SettingSpec>& rotary_axis_specs();
/// Value in the unit of rotary_axis_specs(), an empty text if there is none; `i`: index of that list.
SettingValue rotary_value(const RotaryAxis& axis, std::size_t i);
/// Sets a value; an empty text clears an optional value. Throws InputError as check_setting() does.
void set_rotary_value(RotaryAxis& axis, std::size_t i, const SettingValue& value);

/// Shortest time over `way` from rest to rest with these limits, all > 0, phases of constant jerk and
/// symmetric ramps (core/models/README.md), in the units of `way` and s.
double rest_to_rest_time(double way, double velocity, double acceleration, double jerk);
/// State of such a motion at one instant.
struct RestToRestPlace {
  double way = 0;       ///< from its start
  double velocity = 0;  ///< along the way, >= 0
  double acceleration = 0;
  double jerk = 0;
};
/// State of the motion with rest_to_rest_time(), `time` from its start, at rest before and after it [s];
/// `way` > 0.
RestToRestPlace rest_to_rest_at(double time, double way, double velocity, double acceleration, double jerk);
/// Largest velocity, acceleration and jerk of that motion, and its distance.
RestToRestPlace rest_to_rest_peaks(double way, double velocity, double acceleration, double jerk);
/// Time of a turn by `angle` [rad] from rest to rest [s]: jerk-limited, at most at `feed` [rad/s], or for 0
/// as fast as the axis can (core/models/README.md).
double turning_time(const RotaryAxis& axis, double angle, double feed = 0);

}  // namespace feedscope
