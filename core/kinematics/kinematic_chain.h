#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/kinematics/series.h"

namespace feedscope {

/// An axis of a kinematic chain.
struct ChainAxis {
  char name = ' ';
  bool rotary = false;
  bool carries_part = false;  ///< else it carries the tool
  Vec3 direction =
      Vec3::UnitZ();          ///< of a linear axis: which way the slide goes; rotary: right-handed about it
  Vec3 point = Vec3::Zero();  ///< rotary: on its line, where all axes are at zero [mm]
  double least = -std::numeric_limits<double>::infinity();  ///< travel [mm], [rad]
  double most = std::numeric_limits<double>::infinity();
};

/// Where the tool is, in coordinates of the part.
struct ToolPose {
  Vec3 tip = Vec3::Zero();         ///< [mm]
  Vec3 direction = Vec3::UnitZ();  ///< unit, from the tip to the spindle
};

/// A way to give the tool a direction: angles of the rotary axes in the order of the chain [rad].
struct RotaryPlaces {
  std::vector<double> angles;
  /// The tool lies along the first rotary axis, whose angle then changes nothing: it stays where it was.
  bool singular = false;
};

/// The axes of a machine from the part to the tool: three linear ones and one or two rotary ones, some of
/// which carry the part and some the tool, in any order (table/table, head/table, head/head, nutating).
///
/// With all axes at zero the part's coordinates are those of the machine, and the tool's tip lies
/// `tool_length` before `gauge`, along `tool_direction`. A point x of the tool's side is in coordinates of
/// the part
///   M_1^-1(q_1) ... M_k^-1(q_k)  M_k+1(q_k+1) ... M_n(q_n) x
/// with M a shift along the axis or a turn about its line, axes 1 to k carrying the part.
///
/// Directions from angles and back by the closed form of two turns about crossing directions (Paden and
/// Kahan, subproblem 2, as in Murray, Li, Sastry: A Mathematical Introduction to Robotic Manipulation, 1994,
/// section 3.2), which does not ask that the axes be at right angles.
class KinematicChain {
 public:
  /// `axes` from the part to the tool, those that carry the part first. Throws InputError naming the axis and
  /// what is wrong: no three independent linear axes, no or more than two rotary ones, a direction of length
  /// 0, two rotary axes in parallel, a tool that the last rotary axis does not turn, travel that is empty.
  KinematicChain(std::vector<ChainAxis> axes, const Vec3& gauge, const Vec3& tool_direction);

  const std::vector<ChainAxis>& axes() const { return axes_; }
  std::size_t size() const { return axes_.size(); }
  /// Places in axes() of the rotary ones, in order.
  const std::vector<std::size_t>& rotary() const { return rotary_; }
  const std::vector<std::size_t>& linear() const { return linear_; }

  /// `places` of all axes, [mm] and [rad].
  ToolPose pose(std::span<const double> places, double tool_length) const;

  /// The angles, each in (-pi, pi] or a turn beside it where travel asks for that, that give the tool
  /// `direction` (unit); none where it cannot have it, else one or two, the one nearer to `from` (root of
  /// the sum of squares) first.
  /// `from`: angles of the rotary axes before.
  std::vector<RotaryPlaces> turn_to(const Vec3& direction, std::span<const double> from) const;

  /// Places of all axes with the tip at `tip` and the rotary axes at `angles`.
  std::vector<double> places(const Vec3& tip, std::span<const double> angles, double tool_length) const;

  /// The same with derivatives by the path parameter: how every axis moves.
  std::vector<Series> courses(const std::array<Series, 3>& tip, std::span<const Series> angles,
                              double tool_length) const;
  /// The rotary axes, with derivatives, where the tool's direction changes as `direction` does, each within
  /// half a turn of `at`; of two axes on the side of the pole, the direction of the first one, on which the
  /// second stands at `at`, or the nearer position where it stands at the pole; none where the tool lies
  /// along the first rotary axis: there they have none.
  std::optional<std::vector<Series>> turning(const std::array<Series, 3>& direction,
                                             std::span<const double> at) const;

  /// The first axis beyond its travel; none: all are within.
  std::optional<std::size_t> beyond_travel(std::span<const double> places) const;

 private:
  template <class T>
  std::vector<T> solve(const Eigen::Matrix<T, 3, 1>& tip, std::span<const T> angles,
                       double tool_length) const;
  template <class T>
  std::vector<T> angles_of(const Eigen::Matrix<T, 3, 1>& direction, double side) const;
  /// How far the angle of one rotary axis goes with its direction: -1 for one that carries the part.
  double sense(std::size_t axis) const { return axes_[axis].carries_part ? -1 : 1; }
  /// Within travel, by whole turns as near to `from` as travel allows; none if that is impossible.
  std::optional<double> within_travel(std::size_t axis, double angle, double from) const;

  std::vector<ChainAxis> axes_;
  Vec3 gauge_;
  Vec3 tool_;
  std::vector<std::size_t> rotary_;
  std::vector<std::size_t> linear_;
};

}  // namespace feedscope
