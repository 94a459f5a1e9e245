#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/run/summary.h"
#include "core/models/control_model.h"
#include "tests/contract/motion.h"

namespace feedscope::contract {

/// A promise that a run breaks.
struct Finding {
  std::string check;   ///< short name, the same for the same promise
  std::string detail;  ///< values, bounds, place
};
using Result = std::optional<Finding>;

/// What a run was made of.
struct Inputs {
  const ControlModel& model;
  const Machine& machine;
  const Settings& settings;
  std::shared_ptr<const Toolpath> programmed;
};

/// How far the promised rounding may move a programmed point: half a step of every axis, and 32 bits [mm].
double open_by_rounding(const Motion& motion, const Guarantees& promised, const Machine& machine);

// What must hold of every motion (motion_checks.cpp).

/// Every part lasts, and the parts add up to the cycle time.
Result check_time(const Motion& motion);
/// No NaN and no infinity in any state.
Result check_finite(const Motion& motion);
/// Seconds by cause are not negative and add up to the cycle time within 1e-12; no figure is NaN.
Result check_summary(const Motion& motion, const Machine& machine);
/// Begins and ends at the programmed points, at rest where the speed does not jump.
Result check_ends(const Motion& motion, const Guarantees& promised, const Machine& machine);
/// Position, and what `promised.continuity` says, go on from part to part.
Result check_continuity(const Motion& motion, const Guarantees& promised);
/// Velocity, acceleration, jerk and speed are derivatives of what comes before them.
Result check_derivatives(const Motion& motion);
/// The velocity adds up to the way from the first to the last point.
Result check_displacement(const Motion& motion, const Guarantees& promised, const Machine& machine);
/// state_at_path finds the place of a path length.
Result check_path_lookup(const Motion& motion);

// What the model promises (guarantee_checks.cpp).

/// Axis limits on lines, arcs and blends, component by component; one finding of each limit and kind of
/// place.
std::vector<Finding> check_limits(const Motion& motion, const Guarantees& promised, const Machine& machine);
/// Programmed feed.
Result check_feed(const Motion& motion, const Guarantees& promised);
/// Full stops stand, in the programmed point.
Result check_stops(const Motion& motion, const Guarantees& promised, const Machine& machine);
/// Distance of programmed corners; tangential ends of blocks are met. `tolerance` [mm].
Result check_contour(const Motion& motion, const Guarantees& promised, double tolerance,
                     const Machine& machine);

/// Where rotary axes turn (rotary_checks.cpp): their angles go on from part to part, their velocities are the
/// derivatives, and where the model keeps limits, they keep theirs along feed blocks. Not of filtered motion,
/// nor of controls that make a path of their own.
Result check_rotary(const Motion& motion, const Guarantees& promised, const Machine& machine);

// Runs that must agree with each other (run_checks.cpp).

/// The same bytes when run again.
Result check_again(const Motion& motion, const Inputs& inputs);
/// The same motion in two halves, cut at every full stop in turn.
Result check_split(const Motion& motion, const Guarantees& promised, const Inputs& inputs);
/// On its own path no motion takes less than the bound, model `optimal`. One that exceeds velocity, feed or
/// acceleration must when it is passed so much slower that it keeps them.
Result check_bound(const Motion& motion, const Guarantees& promised, const Inputs& inputs);

}  // namespace feedscope::contract
