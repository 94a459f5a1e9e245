#include "core/models/explanation/turn_reason.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/limits/segment_limits.h"
#include "core/models/explanation/reason_search.h"
#include "core/models/explanation/turn_formula.h"

namespace feedscope {
namespace {

/// Factor by which a corner shortens the executed path. The axes turn that much faster per length there;
/// derivatives of order n grow by its power n. 1 outside corners.
double shortening(const BlendedPath& path, std::uint32_t element) {
  if (!path.in_corner(element)) {
    return 1;
  }
  const double replaced = 2 * path.corner_transition(path.index(element));
  return std::max(1.0, replaced / path.length(element));
}

/// The part of segment `i` on which or next to which the element is; the element runs on the segment or meets
/// it in a corner. Null if one limit applies to all of the segment.
const TurnPart* part_near(const BlendedPath& path, std::uint32_t element, std::size_t i) {
  if (!path.in_corner(element) && path.segment(element) == i) {
    return turn_part(path, element);
  }
  const std::span<const TurnPart> parts = path.programmed()->turn_parts_of(i);
  return parts.empty() ? nullptr : path.segment(element) == i ? &parts.back() : &parts.front();
}

TurnLimit shortened(TurnLimit limit, double by) {
  const int order = limit.by == TurnLimit::By::jerk ? 3 : limit.by == TurnLimit::By::acceleration ? 2 : 1;
  limit.slope *= std::pow(by, order);
  limit.speed /= by;
  return limit;
}

TurnRamp shortened(TurnRamp ramp, double by) {
  ramp.acceleration /= by;
  ramp.acceleration_slope *= ramp.acceleration_by_jerk ? by * by : by;
  ramp.jerk /= by;
  ramp.jerk_slope *= by;
  return ramp;
}

}  // namespace

TurnReasons::TurnReasons(const SimulatedMotion& motion, const ElementLimits& limits)
    : run_(motion.trajectory), machine_(motion.machine), settings_(motion.settings), limits_(limits) {}

/// Reason without a formula so far.
Reason TurnReasons::made(Cause cause, const State& state) const {
  return limits_.made(cause, {}, state.speed, state.element);
}

Reason TurnReasons::find(const State& state, Cause cause) const {
  const BlendedPath& path = run_.path();
  if (path.is_executed() || path.programmed() == nullptr) {
    return made(cause, state);
  }
  const Toolpath& programmed = *path.programmed();
  const std::size_t segment = path.segment(state.element);
  const double shorter = shortening(path, state.element);
  const char* const key = "interpolation_period_s";
  const double period = settings_.has(key) ? settings_.number(key) : 0;
  Reason best = made(cause, state);
  const auto consider = [&](const TurnLimit& programmed_limit, double of_tilt, std::size_t i) {
    const TurnLimit limit = shortened(programmed_limit, shorter);
    const bool sets = cause_of(limit) == cause;
    const std::optional<double> tilt = of_tilt >= 0 ? std::optional(of_tilt) : std::nullopt;
    const Formula formula = sets ? formula_of(limit, machine_, period) : Formula();
    best.tilt = best.tilt ? best.tilt : tilt;
    if (sets && mismatch(formula, state.speed) < mismatch(best.formula, state.speed)) {
      const bool speeds = about_equal(formula.value(), state.speed);
      best.formula = speeds || cause.kind == CauseKind::axis_velocity ? formula : best.formula;
      best.line = programmed.segments[i].line;
      best.tilt = tilt;
    }
  };
  for (std::size_t i = segment; i < std::min(segment + 2, programmed.segments.size()); ++i) {
    const SegmentTurn* turn = programmed.segment_turn(i);
    const TurnPart* part = part_near(path, state.element, i);
    if (part != nullptr || turn != nullptr) {
      consider(part != nullptr ? part->limit : turn->limit, turn != nullptr ? turn->tilt : -1, i);
    }
  }
  for (std::size_t i = segment > 0 ? segment - 1 : 0; i <= segment; ++i) {
    if (const TurnJoint* joint = programmed.turn_joint(i)) {
      consider(joint->limit, joint->tilt, i);
    }
  }
  if (best.formula.empty() && cause.kind != CauseKind::axis_velocity) {
    Reason ramp = on_ramp(state, cause);
    ramp.tilt = ramp.tilt ? ramp.tilt : best.tilt;
    return ramp;
  }
  best.source = limits_.source_of(best.formula.id);
  return best;
}

Reason TurnReasons::on_ramp(const State& state, Cause cause) const {
  const BlendedPath& path = run_.path();
  const Toolpath& programmed = *path.programmed();
  const double acceleration = std::abs(state.tangential_acceleration);
  const double jerk = std::abs(state.tangential_jerk);
  Reason best = made(cause, state);
  const auto consider = [&](const TurnRamp& ramp, double tilt, std::size_t i, double fastest) {
    const bool by_jerk = cause.kind == CauseKind::axis_jerk;
    const bool of_acceleration = ramp.acceleration_axis == cause.axis && ramp.acceleration_by_jerk == by_jerk;
    if (of_acceleration && about_equal(ramp.acceleration, acceleration)) {
      best.formula = formula_of_acceleration(ramp, machine_, fastest);
      best.reached = acceleration;
    } else if (by_jerk && ramp.jerk_axis == cause.axis && about_equal(ramp.jerk, jerk)) {
      best.formula = formula_of_jerk(ramp, machine_);
      best.reached = jerk;
    }
    if (!best.formula.empty()) {
      best.line = programmed.segments[i].line;
      best.tilt = tilt >= 0 ? std::optional(tilt) : std::nullopt;
      best.source = limits_.source_of(best.formula.id);
    }
  };
  const auto fastest_on = [&](std::size_t i, double limit) {
    const Segment& segment = programmed.segments[i];
    return segment.feed > 0 && !segment.rapid ? std::min(limit, segment.feed) : limit;
  };
  look_around(state.element, farthest_of_ramp, path.size(), [&](std::uint32_t element) {
    const double shorter = shortening(path, element);
    const std::size_t segment = path.segment(element);
    const std::size_t end = std::min(segment + 2, programmed.segments.size());
    for (std::size_t i = segment; i < end && best.formula.empty(); ++i) {
      if (const SegmentTurn* turn = programmed.segment_turn(i)) {
        const TurnPart* part = part_near(path, element, i);
        const TurnRamp& ramp = part != nullptr ? part->ramp : turn->ramp;
        const double limit = part != nullptr ? part->limit.speed : turn->limit.speed;
        consider(shortened(ramp, shorter), turn->tilt, i, fastest_on(i, limit) / shorter);
      }
    }
    for (std::size_t i = segment > 0 ? segment - 1 : 0; i < end && best.formula.empty(); ++i) {
      if (const TurnJoint* joint = programmed.turn_joint(i)) {
        consider(shortened(joint->ramp, shorter), joint->tilt, i,
                 fastest_on(i, joint->limit.speed) / shorter);
      }
    }
    return !best.formula.empty();
  });
  return best;
}

}  // namespace feedscope
