#pragma once

#include "core/analysis/explanation/element_limits.h"
#include "core/analysis/explanation/explanation.h"
#include "core/analysis/explanation/turn_reason.h"

namespace feedscope {

/// Finds the formula of a cause at one instant of a run.
class ReasonFinder {
 public:
  /// `run` outlives this.
  explicit ReasonFinder(const Run& run);
  ReasonFinder(const ReasonFinder&) = delete;
  ReasonFinder& operator=(const ReasonFinder&) = delete;

  /// Why the tool is not faster at `state`.
  Reason find(const State& state, Cause cause) const;
  /// Why the tool must be as slow as at `state`, where the place limited by `cause` begins.
  Reason find_at_start(const State& state, Cause cause) const;

 private:
  /// Whether the blend is run by the sampled law of Essid 2019.
  bool is_sampled(const State& state) const;
  Reason on_ramp(const State& state, Cause cause) const;
  Reason braking(const State& state) const;
  /// Braking distance of even deceleration, for a piece of `duration` [s].
  Reason braking_evenly(const Piece& piece, double duration, std::uint32_t element) const;
  Reason at_junction(const State& state, Cause cause) const;
  Reason of_joints(const State& state, Cause cause) const;
  /// The reason if no rotary axis turned.
  Reason without_turns(const State& state, Cause cause) const;
  Reason of_speed(const State& state, Cause cause) const;
  Reason on_blend(const State& state, Cause cause, std::uint32_t element) const;
  Reason sampled_on_blend(const State& state, Cause cause) const;
  Reason whole_axis(const State& state, Cause cause) const;
  Reason made(Cause cause, Formula formula, double reached, std::uint32_t element) const;

  const Trajectory& run_;
  ElementLimits limits_;
  TurnReasons turns_;
  const Run& simulated_;
};

}  // namespace feedscope
