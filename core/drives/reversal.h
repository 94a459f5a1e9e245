#pragma once

#include "core/drives/drive_course.h"

namespace feedscope {

/// What lies between the motor of an axis and its slide: backlash, and friction that holds the slide back
/// when it reverses. The slide is `lead()` ahead of the motor.
///
/// Backlash is play: the slide stands until the motor has turned back by it. At a reversal, noticed once the
/// motor is `least_reversal` back, a deviation of the height of the friction spike against the new direction
/// begins and decays.
class Reversal {
 public:
  static constexpr double least_reversal = 1e-4;  ///< [mm]

  Reversal() = default;
  explicit Reversal(const AxisDrive& drive);

  bool is_rigid() const { return play_ == 0 && spike_ == 0; }
  double lead() const { return slack_ + pull_; }  ///< [mm]
  /// The motor moves by `distance` in one direction within `time` [mm, s].
  void move(double distance, double time);
  /// The motor goes through `course` from `from` to `to` [s].
  void follow(const DriveCourse& course, const DriveLaw& law, double from, double to);

 private:
  void follow_straight(const DriveCourse& course, double from, double to);

  double play_ = 0;    ///< backlash that is not made up for [mm]
  double spike_ = 0;   ///< [mm]
  double decay_ = 0;   ///< time constant of the spike [s]
  double slack_ = 0;   ///< -play/2 ... play/2 [mm]
  double pull_ = 0;    ///< of friction [mm]
  double turned_ = 0;  ///< of the motor since it last ran in `direction_`, -least_reversal ... 0 [mm]
  int direction_ = 0;  ///< in which the motor runs; 0 before it has moved
};

}  // namespace feedscope
