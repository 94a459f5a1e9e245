#include "core/models/optimal/acceleration_law.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

namespace {

/// Cells of a window; doubled where braking takes longer.
constexpr std::size_t window_cells = 4096;

/// Cells before the end of a window that are planned again with the next, where that is possible.
constexpr std::size_t margin_cells = 256;
/// Largest x as a share of K that is clear of it.
constexpr double clear_of_highest = 0.9;

/// Limit of the times that the limits of a window are lowered because its motion exceeds them.
constexpr int max_rounds = 10;
/// Least share of its limits to which a cell is lowered.
constexpr double min_share = 0.5;
/// Load that is accepted; the rest is removed by slowing the stretch down.
constexpr double full_load = 1 + 1e-6;

/// Relative difference below which x counts as the ceiling.
constexpr double at_ceiling = 1e-9;

/// Largest number of curve cells of one piece.
constexpr std::size_t max_joined = 32;

/// Motion of constant jerk from speed `v0` to `v1` over `length` in `time`.
LawPoint joined_motion(double v0, double v1, double length, double time) {
  const double off = v0 + v1 - 2 * length / time;
  return {0, v0, (v1 - v0 - 3 * off) / time, 6 * off / (time * time)};
}

}  // namespace

AccelerationLaw::AccelerationLaw(const AxisVectors& axes, int fineness, TrajectoryBuilder& builder)
    : builder_(builder), cells_(axes, fineness) {}

void AccelerationLaw::run(std::uint32_t first, std::uint32_t last, ProgressSteps& steps) {
  const TrajectoryBuilder::Mark start = builder_.mark();
  excess_ = 1;
  tried_ = max_joined;
  cells_.clear();
  double x = 0;
  std::uint32_t next = first;
  for (std::size_t size = window_cells; next < last || !cells_.empty();) {
    steps.at(builder_.path().segment(next < last ? next : last - 1));
    while (next < last && cells_.size() < size) {
      cells_.add_element(builder_.path(), next++);
    }
    const std::size_t count = plan_window(next == last, x);
    x = add_motion(count, x);
    cells_.drop_front(count);
    size = std::max(window_cells, 2 * cells_.size());
  }
  if (excess_ > 1) {
    builder_.slow_down(start, std::sqrt(excess_));
  }
}

/// Plans a run from `x`; returns the number of cells on which it is settled.
std::size_t AccelerationLaw::plan_window(bool to_rest, double x) {
  reach_back(to_rest ? 0 : infinite);
  changed_.assign(cells_.size(), 1);
  runs_.resize(cells_.size());
  run_on(x);
  for (int round = 0; round < max_rounds && !lowered_.empty(); ++round) {
    lower_exceeded();
    run_on(x);
  }
  return to_rest ? cells_.size() : settled_cells();
}

/// K at the beginning of cell `node`, or at the window's end, from K at the end of that cell.
double AccelerationLaw::highest_at(std::size_t node, double next) const {
  double x = node < cells_.size() ? std::min(cells_.top_at_begin(node), cells_.reach_back(node, next)) : next;
  if (node > 0) {
    x = std::min(x, cells_.top_at_end(node - 1));
  }
  return std::max(x, 0.0);
}

/// K backwards from `end` at the window's end.
void AccelerationLaw::reach_back(double end) {
  end_ = end;
  highest_.resize(cells_.size() + 1);
  for (std::size_t node = highest_.size(); node-- > 0;) {
    highest_[node] = end = highest_at(node, end);
  }
}

/// Number of cells, up to the end of an element, on which K does not depend on the path after the window. The
/// motion ends clear of K there if it can: K falls where cells after it are lowered once their ends are
/// known.
std::size_t AccelerationLaw::settled_cells() const {
  double to_rest = 0;  // K if the motion ended with the window
  std::size_t settled = cells_.size() - 1;
  while (settled > 0 && highest_[settled] != (to_rest = highest_at(settled, to_rest))) {
    --settled;
  }
  const auto last_end = [&](std::size_t count, bool clear) {
    const auto may_end = [&] {
      return cells_[count].element != cells_[count - 1].element &&
             (!clear || runs_[count - 1].x <= clear_of_highest * highest_[count]);
    };
    while (count > 0 && !may_end()) {
      --count;
    }
    return count;
  };
  const std::size_t clear = settled > margin_cells ? last_end(settled - margin_cells, true) : 0;
  return clear > 0 ? clear : last_end(settled, false);
}

/// Runs the changed cells, and those affected by them, starting with `x` at the beginning of the window. Sets
/// lowered_ to those that exceed limits that can be lowered.
void AccelerationLaw::run_on(double x) {
  lowered_.clear();
  bool moved = false;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (changed_[i] != 0 || moved) {
      const double before = runs_[i].x;
      runs_[i] = cells_.run(i, x, highest_[i + 1]);
      moved = runs_[i].x != before;
      changed_[i] = 0;
      if (runs_[i].load > full_load && cells_[i].share > min_share && x <= highest_[i]) {
        lowered_.push_back(static_cast<std::uint32_t>(i));
      }
    }
    x = runs_[i].x;
  }
}

/// Lowers the limits of the cells in lowered_, and K where that changes it.
void AccelerationLaw::lower_exceeded() {
  for (const std::uint32_t i : lowered_) {
    cells_.lower(i, runs_[i].load);
    changed_[i] = 1;
  }
  std::size_t node = highest_.size();
  for (std::size_t n = lowered_.size(); n-- > 0;) {
    node = reach_back_from(lowered_[n], node);
  }
}

/// Recomputes K from the end of cell `lowered` backwards until it is unchanged; K is current from `done` on.
/// Returns the last place visited.
std::size_t AccelerationLaw::reach_back_from(std::size_t lowered, std::size_t done) {
  std::size_t node = std::min(done, lowered + 2);
  for (bool differs = true; node > 0 && (differs || node > lowered);) {
    --node;
    const double before = highest_[node];
    highest_[node] = highest_at(node, node < cells_.size() ? highest_[node + 1] : end_);
    differs = highest_[node] != before;
    if (differs && node > 0) {
      changed_[node - 1] = 1;
    }
  }
  return node;
}

/// Lays the motion over the first `count` cells, from `x`; returns x at their end.
double AccelerationLaw::add_motion(std::size_t count, double x) {
  builder_.reserve_for_path(3 * count, cells_.empty() ? 0 : cells_[0].element);
  for (std::size_t i = 0; i < count;) {
    const LawCell& cell = cells_[i];
    const double end = runs_[i].x;
    std::size_t next = i + 1;
    if (cell.straight) {
      add_phases(i, x, end, {cell.ceiling.value, cell.acceleration, cell.acceleration});
    } else if (runs_[i].steady) {
      add_phases(i, x, end, cells_.phases(i, x, end));
    } else {
      next = i + add_curved(i, count, x);
    }
    x = runs_[next - 1].x;
    i = next;
  }
  return x;
}

/// Number of cells from curved cell `i`, limited by `cause`, that one piece may cross.
std::size_t AccelerationLaw::joinable(std::size_t i, std::size_t count, Cause cause) const {
  const LawCell& cell = cells_[i];
  std::size_t last = i + 1;
  if (builder_.path().kind(cell.element) != ElementKind::fitted) {  // its curves end with cells
    const auto goes_on = [&] {
      return cells_[last].element == cell.element && !cells_[last].straight && !runs_[last].steady &&
             cause_of(last, runs_[last - 1].x, runs_[last]) == cause;
    };
    while (last < std::min(count, i + tried_) && goes_on()) {
      ++last;
    }
  }
  return last - i;
}

/// Lays one piece of constant jerk over curved cell `i`, starting with `x`, and the following cells that it
/// passes in the same time within the limits. Returns the number of cells.
std::size_t AccelerationLaw::add_curved(std::size_t i, std::size_t count, double x) {
  const LawCell& cell = cells_[i];
  const CellRun& run = runs_[i];
  LawPoint from{0, std::sqrt(x), run.begin, run.jerk};
  double time = run.time;
  double load = run.load;
  const Cause cause = cause_of(i, x, run);
  const std::size_t most = joinable(i, count, cause);
  std::size_t joined = most;
  for (; joined > 1; joined = (joined + 1) / 2) {
    double length = 0;
    double whole = 0;
    for (std::size_t k = i; k < i + joined; ++k) {
      length += cells_[k].length;
      whole += runs_[k].time;
    }
    const LawPoint motion = joined_motion(from.v, std::sqrt(runs_[i + joined - 1].x), length, whole);
    const double joined_load = cells_.load_of(i, i + joined, motion, whole, full_load);
    if (joined_load <= full_load) {
      from = motion;
      time = whole;
      load = joined_load;
      break;
    }
  }
  tried_ = joined < most ? joined : std::min(2 * tried_, max_joined);
  builder_.add_piece({0, cell.offset, from.v, from.a, from.j, cell.element, cause}, time);
  excess_ = std::max(excess_, load);
  return joined;
}

/// Accelerates, keeps its speed and decelerates from `x0` to `x1`.
void AccelerationLaw::add_phases(std::size_t i, double x0, double x1, const Phases& phases) {
  const LawCell& cell = cells_[i];
  const auto [ceiling, gain, loss] = phases;
  const double crest = (x0 * loss + x1 * gain + 2 * gain * loss * cell.length) / (gain + loss);
  const double peak = std::max({std::min(ceiling, crest), x0, x1});
  const double up = std::min((peak - x0) / (2 * gain), cell.length);
  const double down = std::min((peak - x1) / (2 * loss), cell.length - up);
  const double level = cell.length - up - down;
  const double v0 = std::sqrt(x0);
  const double v1 = std::sqrt(x1);
  const double top = std::sqrt(peak);
  const double least = 1e-12 * (1 + cell.length);  // mm, far below the resolution of positions
  // On a fitted course one piece would cross many of its curves, where the parts of a motion are not cut.
  const bool whole = builder_.path().kind(cell.element) != ElementKind::fitted;
  double reached = 0;  // omitted phases move the next one: a piece begins at the start of the cell
  const auto add = [&](double from, double to, double length, Cause cause) {
    if (length > least || std::abs(to - from) > at_ceiling * (from + to)) {
      const double time = 2 * length / (from + to);
      const Piece piece{0, cell.offset + reached, from, (to - from) / time, 0, cell.element, cause};
      if (piece.a == 0 && whole) {
        builder_.add_level_piece(piece, time);
      } else {
        builder_.add_piece(piece, time);
      }
      reached += length;
    }
  };
  const bool full = peak >= cell.ceiling.value * (1 - at_ceiling);
  add(v0, top, up, cells_.cause_at_begin(i, x0));
  add(top, top, level, full ? cell.ceiling.cause : Cause{CauseKind::ramp_down});
  add(top, v1, down, {CauseKind::ramp_down});
}

Cause AccelerationLaw::cause_of(std::size_t i, double x0, const CellRun& run) const {
  const LawCell& cell = cells_[i];
  const double top = cell.ceiling.value * (1 - at_ceiling);
  if (x0 >= top && run.x >= top) {
    return cell.ceiling.cause;
  }
  const AxisBound largest = cells_.largest_at_end(i);
  if (run.x >= largest.value * (1 - at_ceiling)) {
    return {CauseKind::axis_acceleration, largest.axis};
  }
  if (run.may_be_faster && run.x < x0) {
    return {CauseKind::ramp_down};
  }
  return cells_.cause_at_begin(i, x0);
}

}  // namespace feedscope
