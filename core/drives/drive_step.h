#pragma once

#include "core/drives/drive_law.h"
#include "core/drives/set_course.h"

namespace feedscope {

/// Response of a drive to any set course after a given time, in closed form: position and velocity are sums
/// over the derivatives of the course and the motor's motion at its start. The factors depend only on drive
/// and time, so axes with equal drives and courses of equal duration share them.
///
/// With the following error e = x - y the drive obeys Tv e'' + e' + Kv e = Tv x'' + (1 - f) x'. The impulse
/// response S_0(t) and its m-fold integrals S_m obey
///
///   Tv S_(m-2) + S_(m-1) + Kv S_m = t^(m-1)/(m-1)!                        (m > 0, S_(-1) = S_0')
///   e(t) = (1 - Kv S_1) e(0) + Tv S_0 e'(0) + sum_k ((1 - f) S_k + Tv S_(k-1)) x^(k)(0)
///
/// without S_0 in the sum. Up to one time constant of the fastest pole the two highest come from their power
/// series and the others from the first equation, downwards; beyond it S_0 is a sum of exponentials, and the
/// equation is used upwards: neither way loses digits. Two real poles far apart have integrals of their own,
/// and S_m is their difference.
class DriveStep {
 public:
  /// Step of zero time.
  DriveStep() = default;
  /// `time` [s] >= 0, for courses of at most `degree`.
  DriveStep(const DriveLaw& law, double time, std::size_t degree = SetCourse::order);

  double time() const { return time_; }  ///< [s]
  std::size_t degree() const { return degree_; }

  struct Answer {
    double travel = 0;    ///< of the set position since the start of the course [mm]
    double error = 0;     ///< following error, set position minus that of the motor [mm]
    double velocity = 0;  ///< of the motor [mm/s]

    MotorMotion motor() const { return {travel - error, velocity}; }
    /// Motion for the start of a course that begins here.
    MotorMotion next_start() const { return {-error, velocity}; }
  };
  /// `start`: of the motor at the start of `set`, whose degree is at most that of this step.
  Answer answer(const SetCourse& set, const MotorMotion& start) const {
    Answer at;
    for (std::size_t k = 1; k <= degree_; ++k) {
      at.travel += power_[k] * set.derivative[k];
      at.error += error_[k] * set.derivative[k];
      at.velocity += velocity_[k] * set.derivative[k];
    }
    // Terms that depend on the end of the previous step come last, so that consecutive steps wait little.
    const double error = -start.offset;
    const double growth = set.derivative[1] - start.velocity;
    at.error += kept_ * error + gained_ * growth;
    at.velocity += pulled_ * error - retained_ * growth;
    return at;
  }

 private:
  using Powers = std::array<double, SetCourse::order + 1>;
  /// S_(-1) ... S_order; S_m at index m + 1.
  using Integrals = std::array<double, SetCourse::order + 2>;

  Integrals integrals(const DriveLaw& law) const;
  Integrals from_series(const DriveLaw& law) const;
  Integrals from_exponentials(const DriveLaw& law) const;
  /// Integrals of exp(-rate t), where Tv is 0 and Kv the rate.
  Integrals of_pole(double rate) const;

  double time_ = 0;
  std::size_t degree_ = SetCourse::order;
  std::size_t top_ = SetCourse::order;  ///< of the integrals
  Powers power_{1};                     ///< time^k/k!
  Powers error_{};                      ///< following error by the k-th derivative of the course
  Powers velocity_{};                   ///< velocity of the motor, likewise
  double kept_ = 1;                     ///< following error by that at the start
  double gained_ = 0;                   ///< following error by the growth of the error at the start [s]
  double pulled_ = 0;                   ///< velocity of the motor by the error at the start [1/s]
  double retained_ = 1;  ///< velocity of the motor by the growth of the error at the start, negative
};

}  // namespace feedscope
