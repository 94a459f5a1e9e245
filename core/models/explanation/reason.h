#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/limits/cause.h"
#include "core/limits/formula.h"
#include "core/machine/machine.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// A motion that a model made, with the arguments of ControlModel::simulate().
struct SimulatedMotion {
  const Trajectory& trajectory;
  const Machine& machine;
  const Settings& settings;
};

/// Why a run stops between two blocks.
enum class StopReason : std::uint8_t {
  unknown,
  end,        ///< the program begins or ends there
  rapid,      ///< a rapid begins or ends there, and the model stops before and after each
  tolerance,  ///< an exact stop is in force, or a contour tolerance of 0
};

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

}  // namespace feedscope
