#pragma once

#include "core/drives/drive_course.h"

namespace feedscope {

/// Effects between the motor of an axis and its slide: backlash, and friction that retards the slide at a
/// reversal. The slide is `lead()` ahead of the motor.
///
/// Backlash is play: the slide stops until the motor has moved back by it. At a reversal, detected once the
/// motor is `least_reversal` back, a deviation with the height of the friction spike against the new
/// direction begins and decays.
class Reversal {
 public:
  static constexpr double least_reversal = 1e-4;  ///< [mm]

  Reversal() = default;
  explicit Reversal(const AxisDrive& drive);

  bool is_rigid() const { return play_ == 0 && spike_ == 0; }
  double lead() const { return slack_ + pull_; }  ///< [mm]
  /// Moves the motor by `distance` in one direction within `time` [mm, s].
  void move(double distance, double time);
  /// Moves the motor along `course` from `from` to `to` [s].
  void follow(const DriveCourse& course, const DriveLaw& law, double from, double to);

 private:
  void follow_straight(const DriveCourse& course, double from, double to);

  double play_ = 0;    ///< backlash that is not compensated [mm]
  double spike_ = 0;   ///< [mm]
  double decay_ = 0;   ///< time constant of the spike [s]
  double slack_ = 0;   ///< -play/2 ... play/2 [mm]
  double pull_ = 0;    ///< of friction [mm]
  double turned_ = 0;  ///< of the motor since it last ran in `direction_`, -least_reversal ... 0 [mm]
  int direction_ = 0;  ///< in which the motor runs; 0 before its first motion
};

}  // namespace feedscope
