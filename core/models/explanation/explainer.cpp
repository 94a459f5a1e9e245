#include "core/models/explanation/explainer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/blend/path_rules.h"
#include "core/limits/segment_limits.h"
#include "core/machine/contour_tolerance.h"
#include "core/models/explanation/reason_search.h"

namespace feedscope {
namespace {

/// Whether the limiting place is a junction.
bool is_of_junction(CauseKind kind) {
  return kind == CauseKind::curvature_crossing || kind == CauseKind::lookahead_horizon ||
         kind == CauseKind::junction_deviation || kind == CauseKind::square_corner_velocity ||
         kind == CauseKind::kink;
}

bool is_blend_row(CauseKind kind) {
  return kind >= CauseKind::blend_velocity && kind <= CauseKind::blend_tangential_jerk;
}

/// Whether rotary axes that turn along the segment may set the limit.
bool is_of_turn(const Trajectory& run, const State& state, Cause cause) {
  if (cause.axis >= static_cast<std::int8_t>(known_axes.size())) {
    return true;
  }
  const BlendedPath& path = run.path();
  const bool by_limit = cause.kind == CauseKind::axis_velocity ||
                        cause.kind == CauseKind::axis_acceleration || cause.kind == CauseKind::axis_jerk;
  return by_limit && cause.axis >= 0 && !path.is_executed() && path.programmed() != nullptr &&
         path.programmed()->segment_turn(path.segment(state.element)) != nullptr;
}

/// Whether a piece on the way to a slower place is not significant by itself: it is very short, or a sample
/// of the law on a blend.
bool is_between(const Trajectory& trajectory, std::size_t index) {
  constexpr double brief = 1e-5;  // [s]
  const Piece& piece = trajectory.pieces()[index];
  const bool sample = piece.law == Law::parameter && (piece.a != 0 || piece.j != 0);
  return sample || trajectory.piece_end(index) - piece.time <= brief;
}

/// Drops the formula of a speed ceiling if the limiting place is farther along the path.
void drop_if_far_off(Reason& reason) {
  constexpr double near = 0.05;
  const bool speed = !reason.formula.empty() && reason.formula.dimension() == Dimension::feed;
  if (speed && std::abs(reason.formula.value() - reason.reached) > near * reason.reached) {
    reason.formula = {};
    reason.source.clear();
  }
}

}  // namespace

bool Reason::sets_it() const {
  return !formula.empty() && about_equal(formula.value(), reached);
}

Explainer::Explainer(const SimulatedMotion& motion, bool stops_at_rapids)
    : ElementLimits(motion), turns_(motion, *this), stops_at_rapids_(stops_at_rapids) {}

Explanation Explainer::explain(const State& state) const {
  Explanation explanation;
  explanation.state = state;
  explanation.reason = find(state, state.cause);
  if (state.cause.kind == CauseKind::ramp_down) {
    explanation.ahead = find_slower_place(state);
  }
  return explanation;
}

SlowerPlace Explainer::find_slower_place(const State& state) const {
  constexpr int max_looks = 64;  // boundaries examined closely where nodes lower each other
  const Trajectory& trajectory = this->trajectory();
  const std::size_t count = trajectory.pieces().size();
  const auto brakes = [&](std::size_t piece) {
    return piece < count && trajectory.pieces()[piece].cause.kind == CauseKind::ramp_down &&
           trajectory.slower_place(piece) == state.slower_place;
  };
  std::size_t piece = trajectory.piece_at(state.time);
  State there;
  Reason reason;
  for (int looks = 0;; ++looks) {
    std::size_t next = piece + 1;
    while (next < count && !brakes(next) && is_between(trajectory, next)) {
      ++next;
    }
    const auto speeds_up = [&] {
      constexpr double rounding = 1e-6;
      const double reached = trajectory.state(trajectory.piece_end(piece)).speed;
      return next != piece + 1 &&
             trajectory.state(trajectory.pieces()[next].time).speed > (1 + rounding) * reached + rounding;
    };
    const bool brakes_on = brakes(next) && !speeds_up();
    if (!brakes_on || looks < max_looks) {
      there = trajectory.state(trajectory.piece_end(piece));
      reason = find_at_start(there, state.slower_place);
    }
    if (!brakes_on || reason.sets_it()) {
      drop_if_far_off(reason);
      return {there.time, there.path_length, there.speed, std::move(reason)};
    }
    piece = next;
  }
}

StopReason Explainer::stop_reason(const State& state) const {
  const Settings& settings = motion().settings;
  const BlendedPath& path = this->path();
  if (path.empty() || path.programmed() == nullptr) {
    return StopReason::unknown;
  }
  const std::uint32_t element = state.element;
  const bool at_start = state.path_length - path.s(element) < path.length(element) / 2;
  if (at_start ? element == 0 : element + std::size_t{1} == path.size()) {
    return StopReason::end;
  }
  const std::size_t before = path.segment(at_start ? element - 1 : element);
  const std::size_t after = path.segment(at_start ? element : element + 1);
  const Toolpath& toolpath = *path.programmed();
  const Segment& a = toolpath.segments[before];
  const Segment& b = toolpath.segments[after];
  if (before == after || a.kind == SegmentKind::dwell || b.kind == SegmentKind::dwell) {
    return StopReason::unknown;
  }
  if (a.rapid || b.rapid) {
    return stops_at_rapids_ ? StopReason::rapid : StopReason::unknown;
  }
  const bool has_tolerance = settings.has(contour_tolerance_key);
  return has_tolerance && PathRules(toolpath, settings).corner_tolerance(before) == 0 ? StopReason::tolerance
                                                                                      : StopReason::unknown;
}

Reason Explainer::find(const State& state, Cause cause) const {
  if (cause.kind == CauseKind::exact_stop || is_pause(cause.kind)) {
    Reason stands = made(cause, {}, 0, state.element);
    stands.stop = is_pause(cause.kind) ? StopReason::unknown : stop_reason(state);
    return stands;
  }
  if (is_of_turn(trajectory(), state, cause)) {
    Reason turn = turns_.find(state, cause);
    const bool rotary = cause.axis >= static_cast<std::int8_t>(known_axes.size());
    if (rotary || turn.sets_it()) {
      return turn;
    }
    Reason own = reason(state, cause);  // the axis may limit by itself here and by rotation elsewhere
    return own.sets_it() ? own : turn;
  }
  return reason(state, cause);
}

bool Explainer::is_of_ramp(CauseKind kind) {
  return kind == CauseKind::axis_acceleration || kind == CauseKind::axis_jerk ||
         kind == CauseKind::path_acceleration;
}

Reason Explainer::reason(const State& state, Cause cause) const {
  if (is_of_ramp(cause.kind)) {
    return on_ramp(state, cause);
  }
  if (is_of_junction(cause.kind)) {
    return at_junction(state, cause);
  }
  if (cause.kind == CauseKind::ramp_down) {
    return braking(state);
  }
  return is_sampled(state) && is_blend_row(cause.kind) ? sampled_on_blend(state, cause)
                                                       : of_speed(state, cause);
}

bool Explainer::is_sampled(const State& state) const {
  const Piece& piece = trajectory().pieces()[trajectory().piece_at(state.time)];
  return piece.law == Law::parameter && (piece.a != 0 || piece.j != 0);
}

Reason Explainer::find_at_start(const State& state, Cause cause) const {
  const bool stop = cause.kind == CauseKind::exact_stop || is_pause(cause.kind);
  const bool filtered = path().kind(state.element) == ElementKind::filtered;
  return is_of_junction(cause.kind) || stop || is_of_ramp(cause.kind) || filtered ||
                 is_of_turn(trajectory(), state, cause)
             ? find(state, cause)
             : of_speed(state, cause);
}

/// Finds the element whose limits the ramp takes: the one that allows least, identified by the axis.
Reason Explainer::on_ramp(const State& state, Cause cause) const {
  const bool by_jerk = cause.kind == CauseKind::axis_jerk;
  const double reached = std::abs(by_jerk ? state.tangential_jerk : state.tangential_acceleration);
  const auto formula_of = [&](std::uint32_t element) {
    return by_jerk ? path_jerk(element) : path_acceleration(element);
  };
  const BlendedPath& path = this->path();
  if (path.kind(state.element) == ElementKind::dwell) {
    return made(cause, {}, reached, state.element);
  }
  std::uint32_t found = state.element;
  look_around(state.element, farthest_of_ramp, path.size(), [&](std::uint32_t element) {
    const bool fits =
        path.kind(element) != ElementKind::dwell && about_equal(formula_of(element).value(), reached);
    found = fits ? element : found;
    return fits || reached == 0;
  });
  return made(cause, formula_of(found), reached, found);
}

/// Length of the braking ramp, from its acceleration and jerk.
Reason Explainer::braking(const State& state) const {
  const Cause cause{CauseKind::ramp_down};
  const std::size_t index = trajectory().piece_at(state.time);
  const Piece& piece = trajectory().pieces()[index];
  if (piece.law == Law::path_length && piece.a < 0 && piece.j == 0) {
    return braking_evenly(piece, trajectory().piece_end(index) - piece.time, state.element);
  }
  if (piece.law != Law::ramp) {
    return made(cause, {}, 0, state.element);
  }
  const PiecePhases phases(piece, trajectory().piece_end(index) - piece.time);
  const LawPoint end = phases.at(trajectory().piece_end(index) - piece.time);
  const Quantity before{Symbol::speed_before, -1, piece.v};
  const Quantity after{Symbol::speed_after, -1, std::max(end.v, 0.0)};
  const Quantity jerk{Symbol::path_jerk, -1, std::abs(piece.j)};
  const Quantity acceleration{Symbol::path_acceleration, -1, std::abs(piece.a)};
  const bool holds = phases.end(1) - phases.begin(1) > 1e-9 * phases.end(0);
  Formula formula = holds ? Formula{FormulaId::braking_acceleration, {before, after, acceleration, jerk}}
                          : Formula{FormulaId::braking_jerk, {before, after, jerk}};
  return made(cause, std::move(formula), end.q - piece.q, state.element);
}

Reason Explainer::braking_evenly(const Piece& piece, double duration, std::uint32_t element) const {
  const LawPoint end = advance({piece.q, piece.v, piece.a, piece.j}, duration);
  return made({CauseKind::ramp_down},
              {FormulaId::braking_evenly,
               {{Symbol::speed_before, -1, piece.v},
                {Symbol::speed_after, -1, std::max(end.v, 0.0)},
                {Symbol::path_acceleration, -1, -piece.a}}},
              end.q - piece.q, element);
}

Reason Explainer::at_junction(const State& state, Cause cause) const {
  constexpr std::uint32_t near = 2;  // the instant is on the junction, or within rounding of it
  Formula best;
  std::uint32_t found = state.element;
  const std::uint32_t first = state.element > near ? state.element - near : 1;
  for (std::uint32_t at = first; at <= state.element + near; ++at) {
    if (at >= path().size() || path().kind(at) == ElementKind::dwell) {
      continue;
    }
    Formula formula = junction(cause.kind, at);
    if (best.empty() || mismatch(formula, state.speed) < mismatch(best, state.speed)) {
      best = std::move(formula);
      found = at;
    }
  }
  return made(cause, std::move(best), state.speed, found);
}

Reason Explainer::of_speed(const State& state, Cause cause) const {
  const BlendedPath& path = this->path();
  const bool blend_row = is_blend_row(cause.kind);
  Reason best = made(cause, {}, state.speed, state.element);
  look_around(state.element, farthest_of_speed, path.size(), [&](std::uint32_t element) {
    Reason reason = blend_row && path.kind(element) == ElementKind::blend
                        ? on_blend(state, cause, element)
                        : made(cause, speed(cause, element), state.speed, element);
    if (best.formula.empty() || reason.sets_it()) {
      best = std::move(reason);
    }
    return best.sets_it();
  });
  return best;
}

/// A blend at constant speed or at constant du/dt has the speed that one of its places allows: the entry, by
/// eq 26 of Essid 2019, or the place where its rows are used most.
Reason Explainer::on_blend(const State& state, Cause cause, std::uint32_t element) const {
  constexpr int intervals = 200;
  const BlendShape shape = blend_shape(element);
  const Piece& piece = trajectory().pieces()[trajectory().piece_at(state.time)];
  const double entry_sigma = shape.at(0).sigma;
  const bool here = piece.law == Law::parameter && piece.element == element;
  const double entry_speed = here ? piece.v * entry_sigma : state.speed;

  Reason best = made(cause, blend_speed(cause, shape, 0, false), entry_speed, element);
  for (const bool steady : {false, true}) {
    double most = 0;
    double place = 0;
    for (int i = 0; i <= intervals; ++i) {
      const double u = static_cast<double>(i) / intervals;
      const double speed = entry_speed * (steady ? shape.at(u).sigma / entry_sigma : 1);
      const double allowed = blend_speed(cause, shape, u, steady).value();
      if (speed > most * allowed) {
        most = speed / allowed;
        place = u;
      }
    }
    Formula formula = blend_speed(cause, shape, place, steady);
    const double speed = entry_speed * (steady ? shape.at(place).sigma / entry_sigma : 1);
    if (mismatch(formula, speed) < mismatch(best.formula, best.reached)) {
      best = made(cause, std::move(formula), speed, element);
    }
  }
  return best;
}

/// Within the law of Essid 2019 on a blend: the row that limits the jerk of the current sample.
Reason Explainer::sampled_on_blend(const State& state, Cause cause) const {
  if (cause.axis < 0) {
    return made(cause, {}, state.speed, state.element);
  }
  const std::size_t index = trajectory().piece_at(state.time);
  const Piece& piece = trajectory().pieces()[index];
  const double u = advance({piece.q, piece.v, piece.a, piece.j}, state.time - piece.time).q;
  const BlendShape::Point p = blend_shape(state.element).at(u);
  const double v = state.speed;
  const double a = state.tangential_acceleration;
  const std::int8_t j = cause.axis;
  const Quantity tangent{Symbol::tangent_part, j, std::abs(p.tangent[j])};
  const Quantity normal{Symbol::normal_part, j, std::abs(p.normal[j])};
  const Quantity acceleration_share{Symbol::acceleration_share, -1, setting("radial_acceleration_share")};
  const Quantity jerk_share{Symbol::jerk_share, -1, setting("radial_jerk_share")};
  const Quantity acceleration{Symbol::axis_acceleration, j, axes().acceleration[j]};
  const Quantity jerk{Symbol::blend_jerk, j, axes().blend_jerk[j]};
  switch (cause.kind) {
    case CauseKind::blend_tangential_acceleration:
      return made(cause, {FormulaId::shared_acceleration, {acceleration_share, acceleration, tangent}},
                  std::abs(a), state.element);
    case CauseKind::blend_tangential_jerk:
      return made(cause, {FormulaId::shared_jerk, {jerk_share, jerk, tangent}},
                  std::abs(state.tangential_jerk - v * v * v * p.k * p.k), state.element);
    case CauseKind::blend_radial_jerk:
      return made(cause, {FormulaId::jerk_across, {jerk_share, jerk, normal}},
                  std::abs(3 * v * a * p.k + v * v * v * p.dk_ds), state.element);
    default:
      return made(cause, blend_speed(cause, blend_shape(state.element), u, false), v, state.element);
  }
}

}  // namespace feedscope
