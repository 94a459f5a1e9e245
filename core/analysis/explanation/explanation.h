#pragma once

#include <optional>

#include "core/analysis/explanation/stop_reason.h"
#include "core/analysis/run.h"
#include "core/limits/formula.h"

namespace feedscope {

/// What limits a run at one place, with the numbers of that place worked out again from machine, settings and
/// path.
struct Reason {
  Cause cause;
  Formula formula;         ///< none where nothing is to be worked out: an exact stop, a dwell
  double reached = 0;      ///< what the run has there of what the formula gives, inside units
  std::uint32_t line = 0;  ///< source line of the place that limits: a ramp may run over many
  std::string source;      ///< paper and equation; "" without formula
  /// Of the tool to the first of two rotary axes, where they turn along the block that limits: the axis turns
  /// by 1/sin of it [rad].
  std::optional<double> tilt = {};
  StopReason stop = StopReason::unknown;  ///< of an exact stop

  /// The formula gives what the run has, to 1e-5 of it.
  bool sets_it() const;
};

/// A place ahead for which the tool slows down.
struct SlowerPlace {
  double time = 0;         ///< it is reached [s]
  double path_length = 0;  ///< there [mm]
  double speed = 0;        ///< there [mm/s]
  Reason reason;           ///< why it is slow; without formula where what limits lies further on
};

/// Why the tool is not faster at one instant.
struct Explanation {
  State state;
  Reason reason;
  std::optional<SlowerPlace> ahead;  ///< where state.cause is ramp_down
};

/// Cost: a few elements about the place, some thousand at most on ramps over many short blocks.
/// `state`: one of run.trajectory.
Explanation explain(const Run& run, const State& state);

/// A time in which the cause stays the same.
struct CauseStretch {
  Cause cause;
  double from = 0;         ///< [s]
  double to = 0;           ///< [s]
  std::uint32_t line = 0;  ///< where it begins
};

/// The stretch about `time`, a border counting for what begins there. Linear in its pieces.
CauseStretch stretch_at(const Trajectory& trajectory, double time);
std::optional<CauseStretch> stretch_before(const Trajectory& trajectory, const CauseStretch& stretch);
std::optional<CauseStretch> stretch_after(const Trajectory& trajectory, const CauseStretch& stretch);

}  // namespace feedscope
