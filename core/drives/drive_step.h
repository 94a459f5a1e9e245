#pragma once

#include "core/drives/drive_law.h"
#include "core/drives/set_course.h"

namespace feedscope {

/// What a drive makes of any set course within a given time, in closed form: position and velocity then are
/// sums over the derivatives of the course and the motion of the motor at its start. The factors depend on
/// drive and time alone, so that axes with equal drives, and courses that last equally long, share them.
///
/// With the following error e = x - y the drive obeys Tv e'' + e' + Kv e = Tv x'' + (1 - f) x'. What answers
/// an impulse, S_0(t), and the m-fold integrals S_m of that obey
///
///   Tv S_(m-2) + S_(m-1) + Kv S_m = t^(m-1)/(m-1)!                        (m > 0, S_(-1) = S_0')
///   e(t) = (1 - Kv S_1) e(0) + Tv S_0 e'(0) + sum_k ((1 - f) S_k + Tv S_(k-1)) x^(k)(0)
///
/// without S_0 in the sum. Over less than a time constant of the fastest pole the two highest come from their
/// power series and the others from the first equation, downwards; over more S_0 is a sum of exponentials,
/// and it is used upwards: both ways no digits are lost. Of two real poles far apart each has integrals of
/// its own, and S_m is their difference.
class DriveStep {
 public:
  /// The step that takes no time.
  DriveStep() = default;
  /// `time` [s] >= 0, for courses of at most `degree`.
  DriveStep(const DriveLaw& law, double time, std::size_t degree = SetCourse::order);

  double time() const { return time_; }  ///< [s]
  std::size_t degree() const { return degree_; }

  struct Answer {
    double travel = 0;    ///< of the set position since the course began [mm]
    double error = 0;     ///< following error, set position less that of the motor [mm]
    double velocity = 0;  ///< of the motor [mm/s]

    MotorMotion motor() const { return {travel - error, velocity}; }
    /// Motion as the start of a course that begins here.
    MotorMotion next_start() const { return {-error, velocity}; }
  };
  /// `start`: of the motor where `set`, of a degree of at most that of this step, begins.
  Answer answer(const SetCourse& set, const MotorMotion& start) const {
    Answer at;
    for (std::size_t k = 1; k <= degree_; ++k) {
      at.travel += power_[k] * set.derivative[k];
      at.error += error_[k] * set.derivative[k];
      at.velocity += velocity_[k] * set.derivative[k];
    }
    // What needs the end of the step before comes last, so that steps in a row wait for little.
    const double error = -start.offset;
    const double growth = set.derivative[1] - start.velocity;
    at.error += kept_ * error + gained_ * growth;
    at.velocity += pulled_ * error - retained_ * growth;
    return at;
  }

 private:
  using Powers = std::array<double, SetCourse::order + 1>;
  /// S_(-1) ... S_order, S_m at m + 1.
  using Integrals = std::array<double, SetCourse::order + 2>;

  Integrals integrals(const DriveLaw& law) const;
  Integrals from_series(const DriveLaw& law) const;
  Integrals from_exponentials(const DriveLaw& law) const;
  /// Of exp(-rate t), where Tv is 0 and Kv the rate.
  Integrals of_pole(double rate) const;

  double time_ = 0;
  std::size_t degree_ = SetCourse::order;
  std::size_t top_ = SetCourse::order;  ///< of the integrals
  Powers power_{1};                     ///< time^k/k!
  Powers error_{};                      ///< following error by the k-th derivative of the course
  Powers velocity_{};                   ///< velocity of the motor by the same
  double kept_ = 1;                     ///< following error by that at the start
  double gained_ = 0;                   ///< the same by the growth of the error at the start [s]
  double pulled_ = 0;                   ///< velocity of the motor by the error at the start [1/s]
  double retained_ = 1;                 ///< the same by the growth of the error at the start, negative
};

}  // namespace feedscope
