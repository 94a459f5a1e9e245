#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/kinematics/kinematic_chain.h"
#include "core/machine/rotary_axis.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Of a rotary axis, in lists by rotary_names.
inline std::size_t rotary_place(char name) {
  return rotary_names.find(name);
}

/// Of the tool in the coordinates of the machine with the rotary axes at `angles`, by rotary_names, unit.
Vec3 tool_direction(const KinematicChain& chain, const std::array<double, 3>& angles);
/// The tip at a place of the path, with its derivatives by it, in the coordinates that the part has on the
/// machine.
std::array<Series, 3> tip_on_machine(const PartOnMachine& part, const CurvePoint& at);

/// How rotary axes go along a segment: linearly by its length, or so that the tool's direction goes along a
/// great circle at an even rate. The two positions of two axes that hold one direction lie on different sides
/// of the pole, the direction of the first axis: on a great circle that does not meet it the axes stay on the
/// side where they begin, and the first one turns with the azimuth about the pole, by less than half a turn.
class TurnCourse {
 public:
  /// `chain` outlives it; `length` of the segment [mm].
  TurnCourse(const KinematicChain& chain, const SegmentTurn& turn, double length);

  /// Whether the axes, as asked, go linearly, or come to the last angles while the tool is on its great
  /// circle: not to a position on the other side, and none that begins at the pole but in the direction of
  /// that side. Where not, they go linearly.
  bool goes_on() const { return way_ != Way::no_circle; }

  /// Angles in the order of KinematicChain::rotary(), with derivatives by the path, `s` from the start [mm].
  std::vector<Series> at(double s) const;
  /// The same by rotary_names; those that the chain lacks are zero.
  std::array<double, 3> angles(double s) const;
  /// On a great circle: where the tool is nearest to the pole or to the direction opposite [mm].
  std::optional<double> nearest_to_pole() const;

 private:
  enum class Way { linear, circle, through_pole, no_circle };

  Way way_on_circle() const;
  std::vector<Series> linear(double s) const;
  /// How far the first axis turns while the tool goes from the start to `direction` and the second axis to
  /// `second`.
  double turn_of_first(const Vec3& direction, double second) const;
  /// Of the tool with the second axis at an angle and the first one at zero.
  Vec3 with_second_at(double angle) const;

  const KinematicChain& chain_;
  double length_;
  std::vector<double> from_;
  std::vector<double> to_;
  // Of a great circle: the direction at the start, the one a quarter turn on, and how far it goes [rad].
  Vec3 start_ = Vec3::Zero();
  Vec3 quarter_ = Vec3::Zero();
  double swing_ = 0;
  Way way_ = Way::linear;
};

}  // namespace feedscope
