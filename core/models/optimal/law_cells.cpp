#include "core/models/optimal/law_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace feedscope {
namespace {

/// As in CellRule: with four cells, where one node lies at the largest curvature of a blend, laws are no
/// faster.
constexpr int min_cells_a_piece = 3;

Vec3 inverse_of(const Vec3& limits) {
  return limits.unaryExpr([](double limit) { return limit > 0 ? 1 / limit : 0; });
}

double largest_of(const Vec3& values) {
  return std::max({std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
}

}  // namespace

LawCells::LawCells(const AxisVectors& axes, int fineness)
    : axes_(axes),
      share_of_acceleration_(inverse_of(axes.acceleration)),
      share_of_velocity_(inverse_of(axes.velocity)) {
  rule_.fineness = fineness;
  rule_.acceleration = axes.acceleration;
  rule_.least = min_cells_a_piece;
}

void LawCells::add_element(const BlendedPath& path, std::uint32_t index) {
  const SpeedBound programmed = element_ceiling(path, index, axes_.velocity);
  rule_.speed = programmed.value;
  const TurnPart* part = turn_part(path, index);
  const SegmentTurn* turn = path.programmed()->segment_turn(path.segment(index));
  const TurnRamp* ramp = part != nullptr ? &part->ramp : turn != nullptr ? &turn->ramp : nullptr;
  path_cells_.clear();
  append_cells(path, index, rule_, path_cells_);
  for (std::size_t i = 0; i < path_cells_.size(); ++i) {
    const PathCell& cell = path_cells_[i];
    if (cell.straight) {
      add_straight(cell, programmed, ramp);
      continue;
    }
    const PathCell* before = i > 0 ? &path_cells_[i - 1] : nullptr;
    const bool goes_on =
        before != nullptr && !before->straight && before->to.t == cell.from.t && before->to.c == cell.from.c;
    add_curved(cell, programmed, goes_on);
  }
}

void LawCells::add_straight(const PathCell& cell, const SpeedBound& programmed, const TurnRamp* ramp) {
  const Vec3 t = cell.from.t.cwiseProduct(share_of_acceleration_);
  const AccelerationRange range(cell.from.t, t, Vec3::Zero());
  LawCell& added = cells_.emplace_back();
  added.length = cell.length;
  added.offset = cell.offset;
  added.ceiling = ceiling_of(programmed, {&cell.from});
  added.acceleration = range.highest(0);
  added.axis = static_cast<std::int8_t>(range.axis_of_highest(0));
  if (ramp != nullptr && ramp->acceleration < added.acceleration) {
    added.acceleration = ramp->acceleration;
    added.axis = ramp->acceleration_axis;
  }
  added.element = cell.element;
  added.straight = true;
}

void LawCells::add_curved(const PathCell& cell, const SpeedBound& programmed, bool goes_on) {
  if (!goes_on) {
    add_place(cell.from);
  }
  LawCell& added = cells_.emplace_back();
  added.length = cell.length;
  added.offset = cell.offset;
  added.ceiling = ceiling_of(programmed, {&cell.from, &cell.middle, &cell.to});
  added.element = cell.element;
  added.straight = false;
  added.place = static_cast<std::uint32_t>(places_.size() - 1);
  add_place(cell.middle);
  const AxisBound largest = places_.back().range.largest_x();
  added.ceiling.lower(largest.value, {CauseKind::axis_acceleration, largest.axis});
  add_place(cell.to);
}

void LawCells::add_place(const PathPoint& at) {
  const Vec3 t = at.t.cwiseProduct(share_of_acceleration_);
  const Vec3 c = at.c.cwiseProduct(share_of_acceleration_);
  places_.push_back({AccelerationRange(at.t, t, c), t, c});
}

/// Speed ceiling of a cell as x = v^2.
SpeedBound LawCells::ceiling_of(const SpeedBound& programmed,
                                std::initializer_list<const PathPoint*> places) const {
  constexpr double nearly = 1 - 1e-9;
  SpeedBound bound = programmed;
  for (const PathPoint* at : places) {
    if (bound.value * largest_of(at->t.cwiseProduct(share_of_velocity_)) > nearly) {
      const AxisBound axis = axis_share(axes_.velocity, at->t);
      bound.lower(axis.value, {CauseKind::axis_velocity, axis.axis});
    }
  }
  bound.value *= bound.value;
  return bound;
}

void LawCells::drop_front(std::size_t count) {
  const auto dropped = static_cast<std::ptrdiff_t>(count);
  std::uint32_t first_place = static_cast<std::uint32_t>(places_.size());
  std::int32_t first_common = static_cast<std::int32_t>(commons_.size());
  for (std::size_t i = size(); i-- > count;) {
    first_place = cells_[i].straight ? first_place : std::min(first_place, cells_[i].place);
    first_common = cells_[i].common < 0 ? first_common : std::min(first_common, cells_[i].common);
  }
  cells_.erase(cells_.begin(), cells_.begin() + dropped);
  places_.erase(places_.begin(), places_.begin() + first_place);
  commons_.erase(commons_.begin(), commons_.begin() + first_common);
  for (LawCell& cell : cells_) {
    cell.place -= cell.straight ? 0 : first_place;
    cell.common -= cell.common < 0 ? 0 : first_common;
  }
}

template <typename Use>
auto LawCells::with_ends(const LawCell& cell, const Use& use) const {
  if (cell.common >= 0) {
    const CommonRange& both = commons_[static_cast<std::size_t>(cell.common)];
    return use(both, both);
  }
  return use(place(cell, 0).range, place(cell, 2).range);
}

double LawCells::top_at_begin(std::size_t i) const {
  const LawCell& cell = cells_[i];
  if (cell.straight) {
    return cell.ceiling.value;
  }
  return with_ends(cell, [&](const auto& from, const auto& /*to*/) {
    return std::min(cell.ceiling.value, from.largest_x().value);
  });
}

double LawCells::top_at_end(std::size_t i) const {
  return std::min(cells_[i].ceiling.value, largest_at_end(i).value);
}

AxisBound LawCells::largest_at_end(std::size_t i) const {
  if (cells_[i].straight) {
    return {infinite, -1};
  }
  return with_ends(cells_[i], [](const auto& /*from*/, const auto& to) { return to.largest_x(); });
}

double LawCells::reach_back(std::size_t i, double next) const {
  const LawCell& cell = cells_[i];
  if (cell.straight) {
    return next + 2 * cell.acceleration * cell.length;
  }
  return with_ends(cell, [&](const auto& from, const auto& to) {
    return from.begin_back(to.reach_back(next, cell.length), cell.length);
  });
}

CellRun LawCells::run(std::size_t i, double x0, double highest) const {
  const LawCell& cell = cells_[i];
  CellRun run;
  if (cell.straight) {
    run.x = std::min(highest, x0 + 2 * cell.acceleration * cell.length);
    run.steady = true;
    return run;
  }
  const bool begins_within = with_ends(
      cell, [&](const auto& from, const auto& to) { return run_curved(cell, from, to, x0, highest, run); });
  run.steady = run.may_be_faster && phases(i, x0, run.x).gain > 0;
  run.load = run.steady ? 0 : load(cell, x0, run, begins_within);
  return run;
}

/// True if its initial acceleration is allowed there.
template <typename Range>
bool LawCells::run_curved(const LawCell& cell, const Range& from, const Range& to, double x0, double highest,
                          CellRun& run) {
  const double strongest = from.highest(x0);
  const double reach = to.reach_on(x0 + cell.length * strongest, cell.length);
  run.may_be_faster = reach > highest;
  run.x = std::max(std::min(highest, reach), 0.0);
  const double mean = (run.x - x0) / (2 * cell.length);
  const double weakest = from.lowest(x0);
  const double begin = std::min(std::max(mean, weakest), strongest);
  const double end = std::min(std::max(2 * mean - begin, to.lowest(run.x)), to.highest(run.x));
  run.begin = 2 * mean - end;

  const double v0 = std::sqrt(x0);
  const double v1 = std::sqrt(run.x);
  const double third = (2 * v0 + v1) / 3;
  if (2 * run.begin * cell.length / 3 < -third * third / 2) {  // it would stop on the way
    run.begin = mean;
  }
  const double root = std::sqrt(third * third + 2 * run.begin * cell.length / 3);
  run.time = 2 * cell.length / (third + root);
  run.jerk = 2 * (v1 - v0 - run.begin * run.time) / (run.time * run.time);
  return run.begin >= weakest && run.begin <= strongest;
}

Phases LawCells::phases(std::size_t i, double x0, double x1) const {
  const LawCell& cell = cells_[i];
  const auto of_ends = [&](const auto& from, const auto& to) {
    const double ceiling = std::min({cell.ceiling.value, from.largest_x().value, to.largest_x().value});
    const double low = std::min(x0, x1);
    const double high = std::max(x0, x1);
    const double crest = std::max(std::min(ceiling, x0 + 2 * from.highest(x0) * cell.length), high);
    Phases phases{crest, infinite, infinite};
    const auto leads_over = [&](const auto& range) {
      phases.gain = std::min({phases.gain, range.highest(low), range.highest(crest)});
      phases.loss = std::min({phases.loss, -range.lowest(low), -range.lowest(crest)});
      return phases.gain > 0 && phases.loss > 0 && x1 <= x0 + 2 * phases.gain * cell.length &&
             x0 <= x1 + 2 * phases.loss * cell.length;
    };
    const bool leads =
        high <= ceiling && leads_over(to) && leads_over(from) && leads_over(place(cell, 1).range);
    return leads ? phases : Phases{crest, 0, 0};
  };
  return with_ends(cell, of_ends);
}

/// Largest acceleration of an axis, or x, over its limit, at some times on the way; `begins_within`: not at
/// its beginning. Tangent and curvature are parabolas along the cell.
double LawCells::load(const LawCell& cell, double x0, const CellRun& run, bool begins_within) const {
  constexpr std::size_t count = 4;
  constexpr std::array<double, count> shares{0.2, 0.5, 0.8, 1.0};
  const Place* at = &places_[cell.place];
  const double v0 = std::sqrt(x0);
  const double whole = 1 / cell.length;
  std::array<double, count> s;
  std::array<double, count> a;
  std::array<double, count> x;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = shares[k] * run.time;
    const double v = v0 + t * (run.begin + t * run.jerk / 2);
    s[k] = t * (v0 + t * (run.begin / 2 + t * run.jerk / 6)) * whole;
    a[k] = run.begin + t * run.jerk;
    x[k] = v * v;
  }
  std::array<double, count> largest{};
  double at_begin = 0;
  for (int j = 0; j < 3; ++j) {
    const double t0 = at[0].t[j], t1 = 4 * at[1].t[j] - 3 * t0 - at[2].t[j];
    const double c0 = at[0].c[j], c1 = 4 * at[1].c[j] - 3 * c0 - at[2].c[j];
    const double t2 = 2 * (t0 + at[2].t[j]) - 4 * at[1].t[j];
    const double c2 = 2 * (c0 + at[2].c[j]) - 4 * at[1].c[j];
    for (std::size_t k = 0; k < count; ++k) {
      const double part =
          std::abs(a[k] * (t0 + s[k] * (t1 + s[k] * t2)) + x[k] * (c0 + s[k] * (c1 + s[k] * c2)));
      largest[k] = part > largest[k] ? part : largest[k];
    }
    at_begin = std::max(at_begin, std::abs(run.begin * t0 + x0 * c0));
  }
  const double largest_x = std::max({x0, x[0], x[1], x[2], x[3]});
  return std::max({begins_within ? 0 : at_begin, largest[0], largest[1], largest[2], largest[3],
                   cell.share * largest_x / cell.ceiling.value});
}

double LawCells::load_of(std::size_t first, std::size_t last, const LawPoint& from, double time,
                         double most) const {
  const double turn = from.j > 0 ? std::clamp(-from.a / from.j, 0.0, time) : 0;
  if (advance(from, turn).v < std::min(from.v, advance(from, time).v) / 2) {
    return infinite;
  }
  double largest = 0;
  LawPoint at = from;
  for (std::size_t i = first; i < last && largest <= most; ++i) {
    const LawCell& cell = cells_[i];
    at.q = 0;
    CellRun run;
    run.begin = at.a;
    run.jerk = at.j;
    run.time = i + 1 < last ? time_to_reach(at, cell.length, time) : time;
    largest = std::max(largest, load(cell, at.v * at.v, run, false));
    at = advance(at, run.time);
    time -= run.time;
  }
  return largest <= most ? largest : infinite;
}

void LawCells::lower(std::size_t i, double load) {
  LawCell& cell = cells_[i];
  if (cell.common < 0) {
    cell.common = static_cast<std::int32_t>(commons_.size());
    commons_.emplace_back(place(cell, 0).range, place(cell, 1).range, place(cell, 2).range);
    return;
  }
  const double factor = 1 / (load * load);
  cell.share *= factor;
  commons_[static_cast<std::size_t>(cell.common)].tighten(factor);
  cell.ceiling.value *= factor;
}

Cause LawCells::cause_at_begin(std::size_t i, double x0) const {
  const LawCell& cell = cells_[i];
  const int axis = cell.straight ? cell.axis : with_ends(cell, [&](const auto& from, const auto& /*to*/) {
    return from.axis_of_highest(x0);
  });
  return {CauseKind::axis_acceleration, static_cast<std::int8_t>(axis)};
}

}  // namespace feedscope
