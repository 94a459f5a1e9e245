#include "core/analysis/agreement/recorded_errors.h"

namespace feedscope {

RecordedErrors::RecordedErrors(const Trace& trace, const TracePose& pose)
    : trace_(&trace), factor_(pose.scale * pose.mirror) {}

Vec3 RecordedErrors::at(std::size_t i) const {
  Vec3 error = Vec3::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto place = static_cast<Eigen::Index>(axis);
    error[place] = has(axis) ? factor_[place] * (raw(i, axis) - raw(0, axis)) : 0;
  }
  return error;
}

}  // namespace feedscope
