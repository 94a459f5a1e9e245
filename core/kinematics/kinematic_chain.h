#pragma once

// Room `kinematics`: axes to tool and back. A KinematicChain of a machine file gives the tool's tip and
// direction for the places of the axes, the places for a pose, and both with derivatives (series.h), which
// limits along the path need.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/kinematics/series.h"

namespace feedscope {

struct ChainAxis {
  char name = ' ';
  bool rotary = false;
  bool carries_part = false;  ///< else it carries the tool
  Vec3 direction =
      Vec3::UnitZ();          ///< linear: direction of motion of the slide; rotary: right-handed about it
  Vec3 point = Vec3::Zero();  ///< rotary: on its line, with all axes at zero [mm]
  double least = -std::numeric_limits<double>::infinity();  ///< travel [mm], [rad]
  double most = std::numeric_limits<double>::infinity();
};

/// Pose of the tool in coordinates of the part.
struct ToolPose {
  Vec3 tip = Vec3::Zero();         ///< [mm]
  Vec3 direction = Vec3::UnitZ();  ///< unit, from the tip to the spindle
};

/// Angles of the rotary axes that give the tool a direction, in the order of the chain [rad].
struct RotaryPlaces {
  std::vector<double> angles;
  /// The tool is parallel to the first rotary axis, whose angle then has no effect: it does not change.
  bool singular = false;
};

/// Axes of a machine from the part to the tool: three linear ones and one or two rotary ones, some of which
/// carry the part and some the tool, in any order (table/table, head/table, head/head, nutating).
///
/// With all axes at zero the part's coordinates are those of the machine, and the tool's tip is `tool_length`
/// before `gauge`, along `tool_direction`. A point x on the tool's side has the part coordinates
///   M_1^-1(q_1) ... M_k^-1(q_k)  M_k+1(q_k+1) ... M_n(q_n) x
/// with M a translation along the axis or a rotation about its line, where axes 1 to k carry the part.
///
/// Directions from angles and back use the closed form of two rotations about intersecting directions (Paden
/// and Kahan, subproblem 2, as in Murray, Li, Sastry: A Mathematical Introduction to Robotic Manipulation,
/// 1994, section 3.2), which does not require axes at right angles.
class KinematicChain {
 public:
  /// `axes` from the part to the tool, those that carry the part first. Throws InputError with axis and
  /// problem: no three independent linear axes, no or more than two rotary ones, a direction of length 0, two
  /// parallel rotary axes, a tool that the last rotary axis does not rotate, empty travel.
  KinematicChain(std::vector<ChainAxis> axes, const Vec3& gauge, const Vec3& tool_direction);

  const std::vector<ChainAxis>& axes() const { return axes_; }
  std::size_t size() const { return axes_.size(); }
  /// Indices in axes() of the rotary ones, in order.
  const std::vector<std::size_t>& rotary() const { return rotary_; }
  const std::vector<std::size_t>& linear() const { return linear_; }

  /// `places`: of all axes, [mm] and [rad].
  ToolPose pose(std::span<const double> places, double tool_length) const;

  /// Angles, each in (-pi, pi] or a full turn away if travel requires it, that give the tool `direction`
  /// (unit); none if it is not reachable, else one or two, first the one nearer to `from` (root of the sum of
  /// squares). `from`: previous angles of the rotary axes.
  std::vector<RotaryPlaces> turn_to(const Vec3& direction, std::span<const double> from) const;

  /// Positions of all axes with the tip at `tip` and the rotary axes at `angles`.
  std::vector<double> places(const Vec3& tip, std::span<const double> angles, double tool_length) const;

  /// Motion of all axes, with derivatives by the path parameter.
  std::vector<Series> courses(const std::array<Series, 3>& tip, std::span<const Series> angles,
                              double tool_length) const;
  /// Rotary axes, with derivatives, for a tool direction that changes as `direction` does, each within half a
  /// turn of `at`. With two axes, the solution on the same side of the pole, the direction of the first axis,
  /// as the second axis at `at`, or the nearer one if that is at the pole. None if the tool is parallel to
  /// the first rotary axis: there are no derivatives there.
  std::optional<std::vector<Series>> turning(const std::array<Series, 3>& direction,
                                             std::span<const double> at) const;

  /// First axis beyond its travel; none if all are within.
  std::optional<std::size_t> beyond_travel(std::span<const double> places) const;

 private:
  template <class T>
  std::vector<T> solve(const Eigen::Matrix<T, 3, 1>& tip, std::span<const T> angles,
                       double tool_length) const;
  template <class T>
  std::vector<T> angles_of(const Eigen::Matrix<T, 3, 1>& direction, double side) const;
  /// Sign of the angle of one rotary axis against its direction: -1 for one that carries the part.
  double sense(std::size_t axis) const { return axes_[axis].carries_part ? -1 : 1; }
  /// Angle within travel, shifted by whole turns as near to `from` as travel allows; none if impossible.
  std::optional<double> within_travel(std::size_t axis, double angle, double from) const;

  std::vector<ChainAxis> axes_;
  Vec3 gauge_;
  Vec3 tool_;
  std::vector<std::size_t> rotary_;
  std::vector<std::size_t> linear_;
};

}  // namespace feedscope
