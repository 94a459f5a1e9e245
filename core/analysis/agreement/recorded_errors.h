#pragma once

#include <array>
#include <cstddef>

#include "core/analysis/agreement/trace_pose.h"
#include "core/trace/trace.h"

namespace feedscope {

/// Following errors of a trace with set and actual positions: set less actual position, less what they differ
/// by in the first sample, since encoders may count from another zero point.
class RecordedErrors {
 public:
  RecordedErrors() = default;
  /// `trace` outlives this. `pose`: how it lies on the program.
  RecordedErrors(const Trace& trace, const TracePose& pose);

  bool has(std::size_t axis) const { return trace_ != nullptr && trace_->has_drive(axis); }
  bool empty() const { return !has(0) && !has(1) && !has(2); }
  /// Of sample `i`; of axes that it does not have 0 [mm].
  Vec3 at(std::size_t i) const;

 private:
  double raw(std::size_t i, std::size_t axis) const {
    return trace_->place[axis][i] - trace_->actual[axis][i];
  }

  const Trace* trace_ = nullptr;
  Vec3 factor_ = Vec3::Ones();  ///< unit and sign
};

}  // namespace feedscope
