#pragma once

#include <optional>

#include "core/analysis/run/run.h"
#include "core/models/explanation/reason.h"

namespace feedscope {

/// Explains a run at `state`, a state of run.trajectory, by its model (ControlModel::explain()).
Explanation explain(const Run& run, const State& state);

/// A time with one limiting cause.
struct CauseStretch {
  Cause cause;
  double from = 0;         ///< [s]
  double to = 0;           ///< [s]
  std::uint32_t line = 0;  ///< where the stretch begins
};

/// Stretch around `time`; at a border, the one that begins there. Linear in its pieces.
CauseStretch stretch_at(const Trajectory& trajectory, double time);
std::optional<CauseStretch> stretch_before(const Trajectory& trajectory, const CauseStretch& stretch);
std::optional<CauseStretch> stretch_after(const Trajectory& trajectory, const CauseStretch& stretch);

}  // namespace feedscope
