#pragma once

#include "core/drives/drive_step.h"

namespace feedscope {

/// A drive on one set course from a given start.
class DriveCourse {
 public:
  /// `law` must outlive this.
  DriveCourse(const DriveLaw& law, const SetCourse& set, const MotorMotion& start)
      : law_(law), set_(set), start_(start) {}

  /// Motion at `h` [s] after the start, 0 <= h <= duration.
  MotorMotion at(double h) const { return DriveStep(law_, h, set_.degree).answer(set_, start_).motor(); }
  /// Motion at the end, as the start of the next course.
  MotorMotion at_end() const {
    return DriveStep(law_, set_.duration, set_.degree).answer(set_, start_).next_start();
  }

 private:
  const DriveLaw& law_;
  SetCourse set_;
  MotorMotion start_;
};

}  // namespace feedscope
