#include "core/models/optimal/acceleration_law.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Cells that are looked at together; doubled where braking takes longer.
constexpr std::size_t window_cells = 4096;

/// How often the limits of a window are lowered where its motion exceeds them.
constexpr int most_rounds = 10;
/// Least share of its limits that a cell is lowered to.
constexpr double least_share = 0.5;
/// Load that is let pass, and then taken out by passing the stretch slower.
constexpr double full_load = 1 + 1e-6;

/// Relative difference below which x counts as the ceiling.
constexpr double at_ceiling = 1e-9;

/// Speed ceiling of a cell as x = v^2.
SpeedBound ceiling_of(const PathCell& cell, const SpeedBound& programmed, const Vec3& velocity) {
  SpeedBound bound = programmed;
  for (const PathPoint* at : {&cell.from, &cell.middle, &cell.to}) {
    const AxisBound axis = axis_share(velocity, at->t);
    bound.lower(axis.value, {CauseKind::axis_velocity, axis.axis});
  }
  bound.value *= bound.value;
  return bound;
}

}  // namespace

AccelerationLaw::AccelerationLaw(const Toolpath& toolpath, const AxisVectors& axes, int fineness,
                                 TrajectoryBuilder& builder)
    : toolpath_(toolpath), axes_(axes), builder_(builder) {
  rule_.fineness = fineness;
  rule_.acceleration = axes.acceleration;
}

void AccelerationLaw::run(std::uint32_t first, std::uint32_t last, ProgressSteps& steps) {
  const TrajectoryBuilder::Mark start = builder_.mark();
  excess_ = 1;
  cells_.clear();
  next_ = first;
  double x = 0;
  for (std::size_t size = window_cells; next_ < last || !cells_.empty();) {
    steps.at(builder_.path().segment(next_ < last ? next_ : last - 1));
    while (next_ < last && cells_.size() < size) {
      add_element(next_++);
    }
    const std::size_t count = plan_window(next_ == last, x);
    x = run_cells(count, x);
    cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(count));
    size = std::max(window_cells, 2 * cells_.size());
  }
  if (excess_ > 1) {
    builder_.slow_down(start, std::sqrt(excess_));
  }
}

/// Sets highest_ for a run from `x` on; returns the number of cells on which it is settled.
std::size_t AccelerationLaw::plan_window(bool to_rest, double x) {
  const double end = to_rest ? 0 : infinite;
  reach_back(end, highest_);
  for (int round = 0; round < most_rounds && lower_exceeded(x); ++round) {
    reach_back(end, highest_);
  }
  if (to_rest) {
    return cells_.size();
  }
  reach_back(0, highest_to_rest_);
  return settled_cells();
}

void AccelerationLaw::add_element(std::uint32_t index) {
  const SpeedBound programmed = programmed_speed(toolpath_, builder_.path().segment(index), axes_.velocity);
  rule_.speed = programmed.value;
  path_cells_.clear();
  append_cells(builder_.path(), index, rule_, path_cells_);
  for (const PathCell& cell : path_cells_) {
    const AccelerationRange from(cell.from, axes_.acceleration);
    const bool straight = cell.straight;
    SpeedBound ceiling = ceiling_of(cell, programmed, axes_.velocity);
    if (straight) {
      cells_.push_back({cell.length, cell.offset, cell.element, straight, ceiling, from, from, from, {}});
      continue;
    }
    const AccelerationRange middle(cell.middle, axes_.acceleration);
    const AxisBound largest = middle.largest_x();
    ceiling.lower(largest.value, {CauseKind::axis_acceleration, largest.axis});
    cells_.push_back({cell.length,
                      cell.offset,
                      cell.element,
                      straight,
                      ceiling,
                      from,
                      middle,
                      AccelerationRange(cell.to, axes_.acceleration),
                      {cell.from, cell.middle, cell.to}});
  }
}

/// K backwards from `end` at the window's end.
void AccelerationLaw::reach_back(double end, std::vector<double>& highest) const {
  highest.resize(cells_.size() + 1);
  const auto ceiling = [](const Cell& cell, const AccelerationRange& at) {
    return std::min(cell.ceiling.value, at.largest_x().value);
  };
  double next = cells_.empty() ? end : std::min(end, ceiling(cells_.back(), cells_.back().to));
  highest.back() = next;
  for (std::size_t i = cells_.size(); i-- > 0;) {
    const Cell& cell = cells_[i];
    double x = ceiling(cell, cell.from);
    if (i > 0) {
      x = std::min(x, ceiling(cells_[i - 1], cells_[i - 1].to));
    }
    x = std::min(x, cell.from.begin_back(cell.to.reach_back(next, cell.length), cell.length));
    highest[i] = next = std::max(x, 0.0);
  }
}

/// Number of cells, up to the end of an element, on which K does not depend on what follows the window.
std::size_t AccelerationLaw::settled_cells() const {
  for (std::size_t i = cells_.size() - 1; i > 0; --i) {
    if (highest_[i] == highest_to_rest_[i] && cells_[i].element != cells_[i - 1].element) {
      return i;
    }
  }
  return 0;
}

/// Lowers the limits of the cells that the motion from `x` on exceeds; whether there are any.
bool AccelerationLaw::lower_exceeded(double x) {
  bool any = false;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Cell& cell = cells_[i];
    if (cell.straight) {
      x = straight_end(cell, x, highest_[i + 1]);
      continue;
    }
    const CurvedMotion motion = curved_motion(cell, x, highest_[i + 1]);
    const bool steady = motion.may_be_faster && curved_phases(cell, x, motion.x).gain > 0;
    const double loaded = steady ? 0 : load(cell, x, motion);
    if (loaded > full_load && cell.share > least_share) {
      guard(cell, loaded);
      any = true;
    }
    x = motion.x;
  }
  return any;
}

/// From now on the cell keeps at both ends what is allowed anywhere on it, and in between as well, the
/// limits being linear in x and u; where that is done already, a little less.
void AccelerationLaw::guard(Cell& cell, double loaded) {
  if (!cell.guarded) {
    cell.guarded = true;
    cell.from.intersect(cell.middle);
    cell.from.intersect(cell.to);
    cell.to = cell.from;
    return;
  }
  const double factor = 1 / (loaded * loaded);
  cell.share *= factor;
  cell.from.tighten(factor);
  cell.to.tighten(factor);
  cell.ceiling.value *= factor;
}

/// Runs the first `count` cells from `x`; returns x at their end.
double AccelerationLaw::run_cells(std::size_t count, double x) {
  for (std::size_t i = 0; i < count; ++i) {
    x = cells_[i].straight ? run_straight(cells_[i], x, highest_[i + 1])
                           : run_curved(cells_[i], x, highest_[i + 1]);
  }
  return x;
}

double AccelerationLaw::straight_end(const Cell& cell, double x0, double highest) {
  return std::min(highest, x0 + 2 * cell.from.highest(0) * cell.length);
}

double AccelerationLaw::run_straight(const Cell& cell, double x0, double highest) {
  const double a = cell.from.highest(0);
  const double x1 = straight_end(cell, x0, highest);
  add_phases(cell, x0, x1, {cell.ceiling.value, a, a});
  return x1;
}

/// Accelerates, keeps its speed and decelerates from `x0` to `x1`.
void AccelerationLaw::add_phases(const Cell& cell, double x0, double x1, const Phases& phases) {
  const auto [ceiling, gain, loss] = phases;
  const double crest = (x0 * loss + x1 * gain + 2 * gain * loss * cell.length) / (gain + loss);
  const double peak = std::max({std::min(ceiling, crest), x0, x1});
  const double up = std::min((peak - x0) / (2 * gain), cell.length);
  const double down = std::min((peak - x1) / (2 * loss), cell.length - up);
  const double level = cell.length - up - down;
  const double v0 = std::sqrt(x0);
  const double v1 = std::sqrt(x1);
  const double top = std::sqrt(peak);
  const double least = 1e-12 * (1 + cell.length);  // mm, far below what positions resolve
  double reached = 0;  // what is left out moves the next one: a piece begins where the cell does
  const auto add = [&](double from, double to, double length, Cause cause) {
    if (length > least || std::abs(to - from) > at_ceiling * (from + to)) {
      const double time = 2 * length / (from + to);
      builder_.add_piece({0, cell.offset + reached, from, (to - from) / time, 0, cell.element, cause}, time);
      reached += length;
    }
  };
  const auto axis = static_cast<std::int8_t>(cell.from.axis_of_highest(x0));
  const bool full = peak >= cell.ceiling.value * (1 - at_ceiling);
  add(v0, top, up, {CauseKind::axis_acceleration, axis});
  add(top, top, level, full ? cell.ceiling.cause : Cause{CauseKind::ramp_down});
  add(top, v1, down, {CauseKind::ramp_down});
}

/// What constant accelerations a cell of a curve allows all over; `gain` is 0 if they do not lead to `x1`.
AccelerationLaw::Phases AccelerationLaw::curved_phases(const Cell& cell, double x0, double x1) {
  const double ceiling =
      std::min({cell.ceiling.value, cell.from.largest_x().value, cell.to.largest_x().value});
  const double crest = std::min(ceiling, x0 + 2 * cell.from.highest(x0) * cell.length);
  Phases phases{crest, infinite, infinite};
  for (const AccelerationRange* range : {&cell.from, &cell.middle, &cell.to}) {
    for (const double x : {std::min(x0, x1), crest}) {
      phases.gain = std::min(phases.gain, range->highest(x));
      phases.loss = std::min(phases.loss, -range->lowest(x));
    }
  }
  const bool leads = std::max(x0, x1) <= ceiling && phases.gain > 0 && phases.loss > 0 &&
                     x1 <= x0 + 2 * phases.gain * cell.length && x0 <= x1 + 2 * phases.loss * cell.length;
  return leads ? phases : Phases{crest, 0, 0};
}

AccelerationLaw::CurvedMotion AccelerationLaw::curved_motion(const Cell& cell, double x0, double highest) {
  CurvedMotion motion;
  const double strongest = cell.from.highest(x0);
  const double reach = cell.to.reach_on(x0 + cell.length * strongest, cell.length);
  motion.may_be_faster = reach > highest;
  motion.x = std::max(std::min(highest, reach), 0.0);
  const double mean = (motion.x - x0) / (2 * cell.length);
  const double begin = std::min(std::max(mean, cell.from.lowest(x0)), strongest);
  const double end =
      std::min(std::max(2 * mean - begin, cell.to.lowest(motion.x)), cell.to.highest(motion.x));
  motion.begin = 2 * mean - end;

  const double v0 = std::sqrt(x0);
  const double v1 = std::sqrt(motion.x);
  const double third = (2 * v0 + v1) / 3;
  if (2 * motion.begin * cell.length / 3 < -third * third / 2) {  // would come to a standstill on the way
    motion.begin = mean;
  }
  const double root = std::sqrt(third * third + 2 * motion.begin * cell.length / 3);
  motion.time = 2 * cell.length / (third + root);
  motion.jerk = 2 * (v1 - v0 - motion.begin * motion.time) / (motion.time * motion.time);
  return motion;
}

/// Largest acceleration of an axis, or x, over its limit, at some instants on the way.
double AccelerationLaw::load(const Cell& cell, double x0, const CurvedMotion& motion) const {
  const double v0 = std::sqrt(x0);
  const auto& [from, middle, to] = cell.course;
  double largest = 0;
  for (const double share : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    const double t = share * motion.time;
    const double s = t * (v0 + t * (motion.begin / 2 + t * motion.jerk / 6)) / cell.length;
    const double v = v0 + t * (motion.begin + t * motion.jerk / 2);
    const double a = motion.begin + t * motion.jerk;
    const double x = v * v;
    const auto at = [s](const Vec3& first, const Vec3& second, const Vec3& third) -> Vec3 {
      return (1 - s) * (1 - 2 * s) * first + 4 * s * (1 - s) * second + s * (2 * s - 1) * third;
    };
    const Vec3 axes = at(a * from.t + x * from.c, a * middle.t + x * middle.c, a * to.t + x * to.c);
    largest = std::max(
        {largest, 1 / axis_share(axes_.acceleration, axes).value, cell.share * x / cell.ceiling.value});
  }
  return largest;
}

double AccelerationLaw::run_curved(const Cell& cell, double x0, double highest) {
  const CurvedMotion motion = curved_motion(cell, x0, highest);
  if (motion.may_be_faster) {
    const Phases phases = curved_phases(cell, x0, motion.x);
    if (phases.gain > 0) {
      add_phases(cell, x0, motion.x, phases);
      return motion.x;
    }
  }
  builder_.add_piece(
      {0, cell.offset, std::sqrt(x0), motion.begin, motion.jerk, cell.element, cause_of(cell, x0, motion)},
      motion.time);
  excess_ = std::max(excess_, load(cell, x0, motion));
  return motion.x;
}

Cause AccelerationLaw::cause_of(const Cell& cell, double x0, const CurvedMotion& motion) const {
  const double top = cell.ceiling.value * (1 - at_ceiling);
  if (x0 >= top && motion.x >= top) {
    return cell.ceiling.cause;
  }
  const AxisBound& largest = cell.to.largest_x();
  if (motion.x >= largest.value * (1 - at_ceiling)) {
    return {CauseKind::axis_acceleration, largest.axis};
  }
  if (motion.may_be_faster && motion.x < x0) {
    return {CauseKind::ramp_down};
  }
  return {CauseKind::axis_acceleration, static_cast<std::int8_t>(cell.from.axis_of_highest(x0))};
}

}  // namespace feedscope
