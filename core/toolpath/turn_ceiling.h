#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/kinematics/kinematic_chain.h"
#include "core/machine/machine.h"
#include "core/toolpath/axis_courses.h"
#include "core/toolpath/toolpath.h"
#include "core/toolpath/turn_course.h"

namespace feedscope {

/// Rotary axes along one segment as they turn: by TurnCourse, or at constant angles where no turn is
/// programmed, with the joints at both ends. A joint is not rounded where the tip stops, which the model
/// decides, so there are courses with and without each joint.
class RoundedTurn {
 public:
  /// `chain` and `path`, whose turns and joints are set, outlive it.
  RoundedTurn(const KinematicChain& chain, const Toolpath& path, std::size_t segment);

  /// True if axes turn along the segment as programmed; otherwise only within the reach of a joint.
  bool is_programmed() const { return course_.has_value(); }
  bool turns() const { return course_ || before_ != nullptr || behind_ != nullptr; }
  /// True if X, Y and Z keep the tip on its path.
  bool at_tip() const { return at_tip_; }
  /// Places between which the course is smooth, in order, including both ends of the segment [mm].
  std::vector<double> borders() const;
  /// Programmed angles at `s` from the start [mm], without joints, in the order of KinematicChain::rotary(),
  /// with derivatives by the segment.
  std::vector<Series> programmed(double s) const;
  /// Calls use(angles) for every possible course that turns there.
  template <typename Use>
  void for_courses(double s, const Use& use) const {
    const std::vector<Series> alone = programmed(s);
    if (course_) {
      use(alone);
    }
    const bool near_start = before_ != nullptr && s < before_->behind;
    const bool near_end = behind_ != nullptr && length_ - s < behind_->before;
    if (near_start) {
      use(with_joint(alone, *before_, s));
    }
    if (near_end) {
      use(with_joint(alone, *behind_, -(length_ - s)));
    }
    if (near_start && near_end) {
      use(with_joint(with_joint(alone, *before_, s), *behind_, -(length_ - s)));
    }
  }

 private:
  std::vector<Series> with_joint(std::vector<Series> angles, const TurnJoint& joint, double away) const;

  const KinematicChain& chain_;
  double length_;
  std::optional<TurnCourse> course_;
  std::array<double, 3> kept_{};
  const TurnJoint* before_ = nullptr;
  const TurnJoint* behind_ = nullptr;
  bool at_tip_ = false;
};

/// Speed of the tip at which every axis of a machine keeps its velocity where rotary axes turn: the ceiling
/// of the feed, place by place.
class TurnCeiling {
 public:
  /// `chain`: of the machine.
  TurnCeiling(const Machine& machine, KinematicChain chain);

  /// Sets Toolpath::turn_parts, and the limits and ramps of SegmentTurn to the least of them; turns and
  /// joints are set already.
  ///
  /// A segment is halved until the ceiling on each part, that of its slowest place, differs by 1 % from that
  /// of its fastest one, both not above the feed, and no axis turns by more than 15 degrees on it. Between
  /// two places at a distance h an axis' derivative exceeds the larger one by h^2/8 of its second derivative
  /// at most, so that no place of a part is slower than its ceiling. `bound`: limits of a bound
  /// (TurnLimiter::set_bound()) on the same parts. Throws Cancelled when stopped; `progress` may be null.
  void divide(Toolpath& path, bool bound, const Progress* progress) const;

  /// Limit on a curve from `transition` [mm] before the end of segment `segment` to as far after the start of
  /// the next one: the axes turn evenly by the path that it replaces. `tips`: evenly spaced places of the
  /// curve, an odd number, with derivatives by its length; `length` of the curve [mm].
  TurnLimit on_corner(const Toolpath& path, std::size_t segment, double transition,
                      const std::vector<CurvePoint>& tips, double length) const;

 private:
  /// Derivatives of all axes at a place of a segment.
  struct Look {
    double at = 0;               ///< [mm]
    AxisCourses rounded;         ///< of every possible course
    AxisCourses programmed;      ///< without joints
    std::vector<double> angles;  ///< [rad]
  };
  class Division;

  Look look(const Toolpath& path, const RoundedTurn& turn, std::size_t segment, double at) const;
  void add(const PartOnMachine& part, const CurvePoint& tip, const std::vector<Series>& angles, bool at_tip,
           AxisCourses& courses) const;

  KinematicChain chain_;
  AxisCourses none_;           ///< empty, with the limits of the machine
  AxisCourses none_of_bound_;  ///< empty, with those of a bound
};

}  // namespace feedscope
