#include "core/analysis/explanation/reason_finder.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/explanation/filtered_reason.h"
#include "core/analysis/explanation/joint_limits.h"
#include "core/analysis/explanation/reason_search.h"
#include "core/analysis/explanation/reason_source.h"
#include "core/limits/segment_limits.h"

namespace feedscope {
namespace {

/// Elements that are searched to both sides for the one that limits a speed.
constexpr std::uint32_t farthest_of_speed = 3;

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

}  // namespace

bool Reason::sets_it() const {
  return !formula.empty() && about_equal(formula.value(), reached);
}

ReasonFinder::ReasonFinder(const Run& run)
    : run_(*run.trajectory), limits_(run), turns_(run, limits_), simulated_(run) {}

Reason ReasonFinder::made(Cause cause, Formula formula, double reached, std::uint32_t element) const {
  return made_reason(run_, limits_, cause, std::move(formula), reached, element);
}

Reason ReasonFinder::find(const State& state, Cause cause) const {
  if (cause.kind == CauseKind::exact_stop || is_pause(cause.kind)) {
    Reason stands = made(cause, {}, 0, state.element);
    stands.stop = is_pause(cause.kind) ? StopReason::unknown : stop_reason(simulated_, state);
    return stands;
  }
  if (is_of_turn(run_, state, cause)) {
    Reason turn = turns_.find(state, cause);
    const bool rotary = cause.axis >= static_cast<std::int8_t>(known_axes.size());
    if (rotary || turn.sets_it()) {
      return turn;
    }
    Reason own = without_turns(state, cause);  // the axis may limit by itself here and by rotation elsewhere
    return own.sets_it() ? own : turn;
  }
  return without_turns(state, cause);
}

Reason ReasonFinder::without_turns(const State& state, Cause cause) const {
  const bool on_ramp_up = cause.kind == CauseKind::axis_acceleration || cause.kind == CauseKind::axis_jerk ||
                          cause.kind == CauseKind::path_acceleration;
  if (run_.path().kind(state.element) == ElementKind::filtered) {
    return filtered_reason(run_, simulated_.setup.settings, limits_, state, cause);
  }
  const bool of_arc =
      cause.kind == CauseKind::contour_tolerance || cause.kind == CauseKind::radial_acceleration;
  if (limits_.traits().joints_take_acceleration && (on_ramp_up || of_arc)) {
    return of_joints(state, cause);
  }
  if (on_ramp_up) {
    return limits_.traits().along_and_across ? whole_axis(state, cause) : on_ramp(state, cause);
  }
  if (is_of_junction(cause.kind)) {
    return at_junction(state, cause);
  }
  switch (cause.kind) {
    case CauseKind::ramp_down:
      return braking(state);
    default:
      return is_sampled(state) && is_blend_row(cause.kind) ? sampled_on_blend(state, cause)
                                                           : of_speed(state, cause);
  }
}

bool ReasonFinder::is_sampled(const State& state) const {
  const Piece& piece = run_.pieces()[run_.piece_at(state.time)];
  return piece.law == Law::parameter && (piece.a != 0 || piece.j != 0);
}

Reason ReasonFinder::find_at_start(const State& state, Cause cause) const {
  const bool stop = cause.kind == CauseKind::exact_stop || is_pause(cause.kind);
  const bool axis = cause.kind == CauseKind::axis_acceleration || cause.kind == CauseKind::axis_jerk ||
                    cause.kind == CauseKind::path_acceleration;
  const bool filtered = run_.path().kind(state.element) == ElementKind::filtered;
  return is_of_junction(cause.kind) || stop || axis || filtered || is_of_turn(run_, state, cause)
             ? find(state, cause)
             : of_speed(state, cause);
}

/// Finds the element whose limits the ramp takes: the one that allows least, identified by the axis.
Reason ReasonFinder::on_ramp(const State& state, Cause cause) const {
  const bool by_jerk = cause.kind == CauseKind::axis_jerk;
  const double reached = std::abs(by_jerk ? state.tangential_jerk : state.tangential_acceleration);
  const auto formula_of = [&](std::uint32_t element) {
    return by_jerk ? limits_.path_jerk(element) : limits_.path_acceleration(element);
  };
  const BlendedPath& path = run_.path();
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
Reason ReasonFinder::braking(const State& state) const {
  const Cause cause{CauseKind::ramp_down};
  const std::size_t index = run_.piece_at(state.time);
  const Piece& piece = run_.pieces()[index];
  if (piece.law == Law::path_length && piece.a < 0 && piece.j == 0) {
    return braking_evenly(piece, run_.piece_end(index) - piece.time, state.element);
  }
  if (piece.law != Law::ramp) {
    return made(cause, {}, 0, state.element);
  }
  const PiecePhases phases(piece, run_.piece_end(index) - piece.time);
  const LawPoint end = phases.at(run_.piece_end(index) - piece.time);
  const Quantity before{Symbol::speed_before, -1, piece.v};
  const Quantity after{Symbol::speed_after, -1, std::max(end.v, 0.0)};
  const Quantity jerk{Symbol::path_jerk, -1, std::abs(piece.j)};
  const Quantity acceleration{Symbol::path_acceleration, -1, std::abs(piece.a)};
  const bool holds = phases.end(1) - phases.begin(1) > 1e-9 * phases.end(0);
  Formula formula = holds ? Formula{FormulaId::braking_acceleration, {before, after, acceleration, jerk}}
                          : Formula{FormulaId::braking_jerk, {before, after, jerk}};
  return made(cause, std::move(formula), end.q - piece.q, state.element);
}

Reason ReasonFinder::braking_evenly(const Piece& piece, double duration, std::uint32_t element) const {
  const LawPoint end = advance({piece.q, piece.v, piece.a, piece.j}, duration);
  return made({CauseKind::ramp_down},
              {FormulaId::braking_evenly,
               {{Symbol::speed_before, -1, piece.v},
                {Symbol::speed_after, -1, std::max(end.v, 0.0)},
                {Symbol::path_acceleration, -1, -piece.a}}},
              end.q - piece.q, element);
}

Reason ReasonFinder::at_junction(const State& state, Cause cause) const {
  const auto formula_before = [&](std::uint32_t element) {
    switch (cause.kind) {
      case CauseKind::curvature_crossing:
        return limits_.crossing(element);
      case CauseKind::junction_deviation:
        return limits_.junction_deviation(element);
      case CauseKind::square_corner_velocity:
        return limits_.square_corner(element);
      case CauseKind::lookahead_horizon:
        return limits_.horizon(element);
      default:
        return Formula();
    }
  };
  constexpr std::uint32_t near = 2;  // the instant is on the junction, or within rounding of it
  Formula best;
  std::uint32_t found = state.element;
  const std::uint32_t first = state.element > near ? state.element - near : 1;
  for (std::uint32_t junction = first; junction <= state.element + near; ++junction) {
    if (junction >= run_.path().size() || run_.path().kind(junction) == ElementKind::dwell) {
      continue;
    }
    Formula formula = formula_before(junction);
    if (best.empty() || mismatch(formula, state.speed) < mismatch(best, state.speed)) {
      best = std::move(formula);
      found = junction;
    }
  }
  return made(cause, std::move(best), state.speed, found);
}

/// Limits of LinuxCNC: on a ramp, an arc, or the blend in a corner.
Reason ReasonFinder::of_joints(const State& state, Cause cause) const {
  if (run_.path().kind(state.element) == ElementKind::dwell) {
    return made(cause, {}, 0, state.element);
  }
  if (cause.kind == CauseKind::axis_acceleration) {
    const double reached = std::abs(state.tangential_acceleration);
    return made(
        cause, acceleration_of_joints(run_.path().curve(state.element), limits_.axes().acceleration, reached),
        reached, state.element);
  }
  Reason best = made(cause, {}, 0, state.element);
  look_around(state.element, farthest_of_speed, run_.path().size(), [&](std::uint32_t element) {
    Formula formula =
        run_.path().kind(element) == ElementKind::dwell
            ? Formula()
            : speed_across_arc(run_.path().curve(element), limits_.axes().acceleration, state.speed);
    if (!formula.empty()) {
      best = made(cause, std::move(formula), state.speed, element);
    }
    return best.sets_it();
  });
  return best.sets_it() ? best : made(cause, {}, 0, state.element);
}

Reason ReasonFinder::of_speed(const State& state, Cause cause) const {
  const BlendedPath& path = run_.path();
  const bool blend_row = is_blend_row(cause.kind);
  Reason best = made(cause, {}, state.speed, state.element);
  look_around(state.element, farthest_of_speed, path.size(), [&](std::uint32_t element) {
    Reason reason = blend_row && path.kind(element) == ElementKind::blend
                        ? on_blend(state, cause, element)
                        : made(cause, limits_.speed(cause, element), state.speed, element);
    if (best.formula.empty() || reason.sets_it()) {
      best = std::move(reason);
    }
    return best.sets_it();
  });
  return best;
}

/// A blend at constant speed or at constant du/dt has the speed that one of its places allows: the entry, by
/// eq 26 of Essid 2019, or the place where its rows are used most.
Reason ReasonFinder::on_blend(const State& state, Cause cause, std::uint32_t element) const {
  constexpr int intervals = 200;
  const BlendShape shape = limits_.blend_shape(element);
  const Piece& piece = run_.pieces()[run_.piece_at(state.time)];
  const double entry_sigma = shape.at(0).sigma;
  const bool here = piece.law == Law::parameter && piece.element == element;
  const double entry_speed = here ? piece.v * entry_sigma : state.speed;

  Reason best = made(cause, limits_.blend_speed(cause, shape, 0, false), entry_speed, element);
  for (const bool steady : {false, true}) {
    double most = 0;
    double place = 0;
    for (int i = 0; i <= intervals; ++i) {
      const double u = static_cast<double>(i) / intervals;
      const double speed = entry_speed * (steady ? shape.at(u).sigma / entry_sigma : 1);
      const double allowed = limits_.blend_speed(cause, shape, u, steady).value();
      if (speed > most * allowed) {
        most = speed / allowed;
        place = u;
      }
    }
    Formula formula = limits_.blend_speed(cause, shape, place, steady);
    const double speed = entry_speed * (steady ? shape.at(place).sigma / entry_sigma : 1);
    if (mismatch(formula, speed) < mismatch(best.formula, best.reached)) {
      best = made(cause, std::move(formula), speed, element);
    }
  }
  return best;
}

/// Within the law of Essid 2019 on a blend: the row that limits the jerk of the current sample.
Reason ReasonFinder::sampled_on_blend(const State& state, Cause cause) const {
  if (cause.axis < 0) {
    return made(cause, {}, state.speed, state.element);
  }
  const std::size_t index = run_.piece_at(state.time);
  const Piece& piece = run_.pieces()[index];
  const double u = advance({piece.q, piece.v, piece.a, piece.j}, state.time - piece.time).q;
  const BlendShape::Point p = limits_.blend_shape(state.element).at(u);
  const double v = state.speed;
  const double a = state.tangential_acceleration;
  const std::int8_t j = cause.axis;
  const Quantity tangent{Symbol::tangent_part, j, std::abs(p.tangent[j])};
  const Quantity normal{Symbol::normal_part, j, std::abs(p.normal[j])};
  const Quantity acceleration_share{Symbol::acceleration_share, -1,
                                    limits_.setting("radial_acceleration_share")};
  const Quantity jerk_share{Symbol::jerk_share, -1, limits_.setting("radial_jerk_share")};
  const Quantity acceleration{Symbol::axis_acceleration, j, limits_.axes().acceleration[j]};
  const Quantity jerk{Symbol::blend_jerk, j, limits_.axes().blend_jerk[j]};
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
      return made(cause, limits_.blend_speed(cause, limits_.blend_shape(state.element), u, false), v,
                  state.element);
  }
}

/// Along and across the path together, as the time-optimal law limits them.
Reason ReasonFinder::whole_axis(const State& state, Cause cause) const {
  const bool by_jerk = cause.kind == CauseKind::axis_jerk;
  const bool blend = run_.path().in_corner(state.element);
  const Vec3& limit = !by_jerk ? limits_.axes().acceleration
                      : blend  ? limits_.axes().blend_jerk
                               : limits_.axes().jerk;
  const Vec3& whole = by_jerk ? state.jerk : state.acceleration;
  std::int8_t j = cause.axis;
  for (std::int8_t axis = 0; cause.axis < 0 && axis < 3; ++axis) {
    j = j < 0 || std::abs(whole[axis]) * limit[j] > std::abs(whole[j]) * limit[axis] ? axis : j;
  }
  const Vec3 tangent = state.speed > 0 ? Vec3(state.velocity / state.speed) : Vec3(Vec3::Zero());
  const double along = tangent[j] * (by_jerk ? state.tangential_jerk : state.tangential_acceleration);
  const Quantity part_along{by_jerk ? Symbol::jerk_along : Symbol::acceleration_along, j, along};
  const Quantity part_across{by_jerk ? Symbol::jerk_across : Symbol::acceleration_across, j,
                             whole[j] - along};
  return made(cause,
              {by_jerk ? FormulaId::whole_jerk : FormulaId::whole_acceleration, {part_along, part_across}},
              limit[j], state.element);
}

}  // namespace feedscope
