#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/kinematics/kinematic_chain.h"
#include "core/machine/rotary_axis.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Index of a rotary axis in lists by rotary_names.
inline std::size_t rotary_place(char name) {
  return rotary_names.find(name);
}

/// Unit direction of the tool in machine coordinates with the rotary axes at `angles`, by rotary_names.
Vec3 tool_direction(const KinematicChain& chain, const std::array<double, 3>& angles);
/// Tip at a place of the path, with derivatives by the path, in the coordinates of the part on the machine.
std::array<Series, 3> tip_on_machine(const PartOnMachine& part, const CurvePoint& at);

/// Course of rotary axes along a segment: linear by its length, or such that the tool's direction follows a
/// great circle at an even rate. The two positions of two axes that give one direction lie on different sides
/// of the pole, the direction of the first axis. On a great circle that misses the pole the axes stay on
/// their first side, and the first axis turns with the azimuth about the pole, by less than half a turn.
class TurnCourse {
 public:
  /// `chain` outlives it; `length` of the segment [mm].
  TurnCourse(const KinematicChain& chain, const SegmentTurn& turn, double length);

  /// False if the axes were to follow a great circle and cannot reach the last angles on it: not a position
  /// on the other side, and none from the pole except in the direction of that side. They go linearly then.
  bool goes_on() const { return way_ != Way::no_circle; }

  /// Angles in the order of KinematicChain::rotary(), with derivatives by the path, `s` from the start [mm].
  std::vector<Series> at(double s) const;
  /// The same by rotary_names; zero for axes that the chain lacks.
  std::array<double, 3> angles(double s) const;
  /// On a great circle: place where the tool is nearest to the pole or to the opposite direction [mm].
  std::optional<double> nearest_to_pole() const;

 private:
  enum class Way { linear, circle, through_pole, no_circle };

  Way way_on_circle() const;
  std::vector<Series> linear(double s) const;
  /// Turn of the first axis while the tool goes from the start to `direction` and the second axis to `second`
  /// [rad].
  double turn_of_first(const Vec3& direction, double second) const;
  /// Direction of the tool with the second axis at an angle and the first one at zero.
  Vec3 with_second_at(double angle) const;

  const KinematicChain& chain_;
  double length_;
  std::vector<double> from_;
  std::vector<double> to_;
  // Great circle: direction at the start, direction a quarter turn further, and its angle [rad].
  Vec3 start_ = Vec3::Zero();
  Vec3 quarter_ = Vec3::Zero();
  double swing_ = 0;
  Way way_ = Way::linear;
};

}  // namespace feedscope
