#pragma once

#include "core/models/explanation/element_limits.h"

namespace feedscope {

/// Finds the formula of a cause on blocks along which rotary axes turn: by their limits, or by those of the
/// linear axes that follow them.
class TurnReasons {
 public:
  /// Both outlive this; `limits` is of `motion`.
  TurnReasons(const SimulatedMotion& motion, const ElementLimits& limits);

  /// The turn along the block or the one after a rounded corner, or the joint at an end of the block, that
  /// allows about this speed; on a ramp, about this acceleration or jerk.
  Reason find(const State& state, Cause cause) const;

 private:
  /// Finds the limits of the ramp: those of the segment, or of the joint at its end, that allow least.
  Reason on_ramp(const State& state, Cause cause) const;
  Reason made(Cause cause, const State& state) const;

  const Trajectory& run_;
  const Machine& machine_;
  const Settings& settings_;
  const ElementLimits& limits_;
};

}  // namespace feedscope
