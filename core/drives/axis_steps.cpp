#include "core/drives/axis_steps.h"

#include <algorithm>

namespace feedscope {

void AxisSteps::set(const std::array<DriveLaw, 3>& laws, double time, std::size_t degree) {
  if (known_ && steps_[0].time() == time && steps_[0].degree() == degree) {
    return;
  }
  for (std::size_t axis = 0; !known_ && axis < laws.size(); ++axis) {
    first_like_[axis] =
        static_cast<std::size_t>(std::find(laws.begin(), laws.end(), laws[axis]) - laws.begin());
  }
  known_ = true;
  for (std::size_t axis = 0; axis < steps_.size(); ++axis) {
    if (first_like_[axis] == axis) {
      steps_[axis] = DriveStep(laws[axis], time, degree);
    }
  }
}

}  // namespace feedscope
