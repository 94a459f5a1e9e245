#pragma once

#include <array>

#include "core/kinematics/series.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Largest derivatives by the path of every axis of a machine over some part of it, and the speed and ramps
/// of the tip that the axes allow there. At path speed v an axis with derivatives q1, q2, q3 has
///
///   velocity q1 v, acceleration q2 v^2 + q1 v', jerk q3 v^3 + 3 q2 v v' + q1 v''
class AxisCourses {
 public:
  /// Shares of an axis' limits that turning at a constant speed may use.
  struct Shares {
    double acceleration = turning_acceleration;
    double jerk = turning_jerk;  ///< infinite: jerk is not limited
  };

  explicit AxisCourses(const Machine& machine) : AxisCourses(machine, Shares()) {}
  AxisCourses(const Machine& machine, const Shares& shares);

  /// Adds the derivatives of an axis, an index into cause_axes, at a place of the part.
  void add(std::size_t axis, const Series& course);

  /// Adds the derivatives of another part of the same machine.
  void add(const AxisCourses& other);
  /// Raises the first derivatives to the largest possible between the added places, which are `step` apart
  /// along the path [mm]: by step^2/8 of the third derivatives.
  void reach_between(double step);

  /// Speed at which the first terms use up the velocity and the shares of acceleration and jerk.
  TurnLimit speed() const;
  /// The same by velocity alone, and without velocity.
  TurnLimit speed_of_velocity() const;
  TurnLimit speed_of_bend() const;
  /// Ramps left when turning at `speed`, which may grow over `reach` [mm/s, mm].
  TurnRamp ramp(double speed, double reach) const;

  /// Share of an axis' acceleration that turning at a constant speed may take, as turning_share of
  /// limits/segment_limits.h.
  static constexpr double turning_acceleration = 0.75;
  /// Share of an axis' jerk that turning may use: the more it uses, the less is left for ramps. Our choice:
  /// of 0.6, 0.5, 0.4, 0.3 and 0.2 this one runs the sample blade fastest, by 1 to 10 %.
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

/// Keeps the lower of the two limits.
void lower(TurnLimit& limit, const TurnLimit& other);
void lower(TurnRamp& ramp, const TurnRamp& other);

}  // namespace feedscope
