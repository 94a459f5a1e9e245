#pragma once

#include <array>

#include "core/kinematics/series.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// The largest derivatives by the path of every axis of a machine over some part of it, and what speed and
/// ramps of the tip the axes allow there. By the path's speed v an axis with derivatives q1, q2, q3 has
///
///   velocity q1 v, acceleration q2 v^2 + q1 v', jerk q3 v^3 + 3 q2 v v' + q1 v''
class AxisCourses {
 public:
  /// What of the limits of an axis turning at a constant speed may take.
  struct Shares {
    double acceleration = turning_acceleration;
    double jerk = turning_jerk;  ///< infinite: no jerk is limited
  };

  explicit AxisCourses(const Machine& machine) : AxisCourses(machine, Shares()) {}
  AxisCourses(const Machine& machine, const Shares& shares);

  /// Takes up the derivatives of an axis, a place in cause_axes, at a place of the part.
  void add(std::size_t axis, const Series& course);

  /// Takes up those of another part of the same machine.
  void add(const AxisCourses& other);
  /// Raises the first derivatives to what they can be between the places taken up, which are `step` apart
  /// along the path [mm]: by step^2/8 of the third ones, which bend them.
  void reach_between(double step);

  /// The speed at which velocity and the shares of acceleration and jerk are taken by the first terms.
  TurnLimit speed() const;
  /// The same of the velocity alone, and without it.
  TurnLimit speed_of_velocity() const;
  TurnLimit speed_of_bend() const;
  /// What turning at `speed` leaves for ramps, over `reach` of which the speed may grow [mm/s, mm].
  TurnRamp ramp(double speed, double reach) const;

  /// Share of an axis' acceleration that turning at a constant speed may take, as turning_share of
  /// limits/segment_limits.h.
  static constexpr double turning_acceleration = 0.75;
  /// And of its jerk: the more turning takes, the less is left for ramps. Ours: of 0.6, 0.5, 0.4, 0.3 and 0.2
  /// this one runs the sample blade fastest, by 1 to 10 %.
  static constexpr double turning_jerk = 0.4;

 private:
  /// X, Y, Z, A, B, C, as cause_axes.
  static constexpr std::size_t count = 6;
  struct Course {
    double first = 0, second = 0, third = 0;
    double velocity = 0, acceleration = 0, jerk = 0;  ///< limits

    double jerk_in_bend(double speed, double along) const;
    double acceleration_in_bend(double speed, double reach) const;
    bool limits_jerk() const;
  };

  Shares shares_;
  std::array<Course, count> axes_{};
};

/// Keeps the lower of the two.
void lower(TurnLimit& limit, const TurnLimit& other);
void lower(TurnRamp& ramp, const TurnRamp& other);

}  // namespace feedscope
