#pragma once

#include <array>

#include "core/drives/drive_step.h"

namespace feedscope {

/// Steps of three drives over one time. Equal drives share one, and a repeated step is cached.
class AxisSteps {
 public:
  /// `laws`: the same in every call; `time` [s].
  void set(const std::array<DriveLaw, 3>& laws, double time, std::size_t degree);
  const DriveStep& of(std::size_t axis) const { return steps_[first_like_[axis]]; }

 private:
  bool known_ = false;
  std::array<std::size_t, 3> first_like_{};  ///< first axis with an equal drive
  std::array<DriveStep, 3> steps_;           ///< of those axes
};

}  // namespace feedscope
