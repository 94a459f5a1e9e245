#pragma once

#include <optional>

#include "core/analysis/explanation/stop_reason.h"
#include "core/analysis/run/run.h"
#include "core/limits/formula.h"

namespace feedscope {

/// Limiting cause of a run at one place, with the numbers there recomputed from machine, settings and path.
struct Reason {
  Cause cause;
  Formula formula;         ///< none if nothing is computed: an exact stop, a dwell
  double reached = 0;      ///< value of the run for the quantity of the formula, internal units
  std::uint32_t line = 0;  ///< source line of the limiting place: a ramp may extend over many
  std::string source;      ///< paper and equation; "" without formula
  /// Angle between the tool and the first of two rotary axes [rad], if they turn along the limiting block:
  /// the axis turns by 1/sin of it.
  std::optional<double> tilt = {};
  StopReason stop = StopReason::unknown;  ///< of an exact stop

  /// Whether the formula gives the value of the run, within 1e-5 of it.
  bool sets_it() const;
};

/// A place ahead that the tool slows down for.
struct SlowerPlace {
  double time = 0;         ///< when it is reached [s]
  double path_length = 0;  ///< there [mm]
  double speed = 0;        ///< there [mm/s]
  Reason reason;  ///< why it is slow; without formula if the limiting place is farther along the path
};

/// Why the tool is not faster at a given instant.
struct Explanation {
  State state;
  Reason reason;
  std::optional<SlowerPlace> ahead;  ///< where state.cause is ramp_down
};

/// Explains a run at `state`, a state of run.trajectory. Cost: a few elements around the place, up to some
/// thousand on ramps over many short blocks.
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
