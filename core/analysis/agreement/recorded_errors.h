#pragma once

#include <array>
#include <cstddef>

#include "core/analysis/agreement/trace_pose.h"
#include "core/trace/trace.h"

namespace feedscope {

/// Following errors of a trace with set and actual positions: set minus actual position, relative to the
/// first sample, since encoders may have another zero point.
class RecordedErrors {
 public:
  RecordedErrors() = default;
  /// `trace` outlives this. `pose`: of the trace relative to the program.
  RecordedErrors(const Trace& trace, const TracePose& pose);

  bool has(std::size_t axis) const { return trace_ != nullptr && trace_->has_drive(axis); }
  bool empty() const { return !has(0) && !has(1) && !has(2); }
  /// Of sample `i` [mm]; 0 for axes without one.
  Vec3 at(std::size_t i) const;

 private:
  double raw(std::size_t i, std::size_t axis) const {
    return trace_->place[axis][i] - trace_->actual[axis][i];
  }

  const Trace* trace_ = nullptr;
  Vec3 factor_ = Vec3::Ones();  ///< unit and sign
};

}  // namespace feedscope
