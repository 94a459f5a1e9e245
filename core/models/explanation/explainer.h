#pragma once

#include "core/models/explanation/element_limits.h"
#include "core/models/explanation/turn_reason.h"

namespace feedscope {

/// Finds why a motion is not faster, with the formulas and numbers of its limits there. A model whose reasons
/// are others derives from it.
class Explainer : public ElementLimits {
 public:
  /// What `motion` refers to outlives this. `stops_at_rapids`: the model stops before and after each rapid.
  explicit Explainer(const SimulatedMotion& motion, bool stops_at_rapids = true);

  /// `state`: one of the motion.
  Explanation explain(const State& state) const;

 protected:
  /// Why the tool is not faster at `state` by `cause`, if no rotary axis sets the limit.
  virtual Reason reason(const State& state, Cause cause) const;
  /// Whether the cause is a limit of a ramp that speeds up.
  static bool is_of_ramp(CauseKind kind);

 private:
  /// Why the tool is not faster at `state`.
  Reason find(const State& state, Cause cause) const;
  /// Why the tool must be as slow as at `state`, where the place limited by `cause` begins.
  Reason find_at_start(const State& state, Cause cause) const;
  /// Follows the pieces that brake for the same place, starting at `state.time`. What brakes from a higher
  /// speed than was reached brakes for another place.
  SlowerPlace find_slower_place(const State& state) const;
  /// Reason at the block border nearest to `state`.
  StopReason stop_reason(const State& state) const;
  /// Whether the blend is run by the sampled law of Essid 2019.
  bool is_sampled(const State& state) const;
  Reason on_ramp(const State& state, Cause cause) const;
  Reason braking(const State& state) const;
  /// Braking distance of even deceleration, for a piece of `duration` [s].
  Reason braking_evenly(const Piece& piece, double duration, std::uint32_t element) const;
  Reason at_junction(const State& state, Cause cause) const;
  Reason of_speed(const State& state, Cause cause) const;
  Reason on_blend(const State& state, Cause cause, std::uint32_t element) const;
  Reason sampled_on_blend(const State& state, Cause cause) const;

  TurnReasons turns_;
  bool stops_at_rapids_;
};

}  // namespace feedscope
