#include "core/models/optimal/jerk_law.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr double digits = 2e-16;       ///< of a path length
constexpr double rounded_jerk = 1e-4;  ///< share of the jerk that rounding of a cell's length may make
constexpr double ramp_cells = 5;       ///< cells in the time of the shortest ramp
constexpr double stretch_cells = 20;   ///< cells of a stretch at least
constexpr double growth = 0.4;         ///< of cells by time, away from where the law may change
/// Cells last longer in the first law than they will, up to this share, where it is slower than the feed.
constexpr double min_speed_share = 0.3;
constexpr double level_after = 2;  ///< ramp times within which they stay short
/// The law is passed slower in such steps, which do not hang on the rounding of path lengths.
constexpr double excess_step = 1e-4;
constexpr double cell_turn = 0.15;  ///< [rad]
constexpr std::size_t jerk_window_cells = 256;
constexpr double window_ramps = 8;  ///< a window lasts so many ramps at least

/// What the cells that begin in [from, to) turn by [rad].
double turn_of(const std::vector<PathCell>& cells, double from, double to) {
  const auto before = [](const PathCell& cell, double offset) { return cell.offset < offset; };
  double turn = 0;
  for (auto cell = std::lower_bound(cells.begin(), cells.end(), from, before);
       cell != cells.end() && cell->offset < to; ++cell) {
    turn += cell->middle.c.norm() * cell->length;
  }
  return turn;
}

}  // namespace

JerkLaw::JerkLaw(const AxisVectors& axes, TrajectoryBuilder& builder) : axes_(axes), builder_(builder) {
  rule_.acceleration = axes.acceleration;
  rule_.jerk = axes.jerk.cwiseMin(axes.blend_jerk);
}

void JerkLaw::run(std::uint32_t first, std::uint32_t last, ProgressSteps& steps) {
  steps.at(builder_.path().segment(first));
  const TrajectoryBuilder::Mark start = builder_.mark();
  excess_ = 1;
  plan(first, last);
  const double planned = static_law_.duration();
  start_strictly(first, last);
  improve(steps);
  if (static_law_.is_straight() && time() >= planned) {
    plan(first, last);
    add_planned(first, last);
    return;
  }
  for (std::size_t i = 0; i < cells_.size(); i += jerk_window_cells) {
    const std::size_t end = std::min(i + jerk_window_cells, cells_.size());
    fill_places(i, end);
    add_pieces(i, end);
  }
  if (excess_ > 1) {
    builder_.slow_down(start, std::ceil(excess_ / excess_step) * excess_step);
  }
}

const Vec3& JerkLaw::jerk_of(std::uint32_t index) const {
  return builder_.path().in_corner(index) ? axes_.blend_jerk : axes_.jerk;
}

void JerkLaw::load_element(std::uint32_t index, int fineness) {
  stop_if_cancelled(builder_.progress());
  rule_.fineness = fineness;
  feed_ = element_ceiling(builder_.path(), index, axes_.velocity);
  rule_.speed = feed_.value;
  geometry_.clear();
  append_cells(builder_.path(), index, rule_, geometry_);
  straight_ = all_straight(geometry_);
  loaded_ = index;
  at_ = 0;
}

void JerkLaw::plan(std::uint32_t first, std::uint32_t last) {
  static_law_.clear();
  for (std::uint32_t e = first; e < last; ++e) {
    load_element(e);
    static_law_.add_element(geometry_, e, feed_, axes_, jerk_of(e));
  }
  static_law_.plan();
}

void JerkLaw::cut_cells(std::uint32_t first, std::uint32_t last) {
  static_law_.rewind();
  cells_.clear();
  nodes_.assign(1, {});
  // A shorter cell would have its jerk from the rounding of its length.
  const double min_jerk = std::min(axes_.jerk.minCoeff(), axes_.blend_jerk.minCoeff());
  min_time_ = std::cbrt(digits * (1 + static_law_.length()) / (rounded_jerk * min_jerk));
  std::size_t part = 0;
  for (std::uint32_t e = first; e < last; ++e) {
    load_element(e);
    const double begin = static_law_.part_begin(part);
    double reached = 0;
    for (bool ends = false; !ends; ++part) {
      ends = static_law_.ends_element(part);
      const double to = ends ? law_length(builder_.path(), e) : static_law_.part_end(part) - begin;
      reached = cut_part(e, begin, reached, to, part);
    }
  }
  nodes_.back() = {};
}

/// Cells up to `to` on the element, of about equal time near the ends of the part, longer ones away from
/// them; they turn little. Returns where the last one ends, before `to` where that is next to nothing away
/// [mm].
double JerkLaw::cut_part(std::uint32_t index, double begin, double from, double to, std::size_t part) {
  const std::size_t place = static_law_.place();
  const double start = static_law_.time_at(begin + from);
  const double duration = static_law_.time_at(begin + to) - start;
  static_law_.rewind(place);
  const bool ends = to == law_length(builder_.path(), index);
  if (duration < min_time_ && (!ends || from > 0)) {
    if (ends) {
      const Motion1d at = static_law_.at(start + duration);
      cells_.back().length = to - cells_.back().offset;
      nodes_.back() = {std::max(at.v, 0.0), at.a};
    }
    return from;
  }
  const double jerk = axis_share(jerk_of(index), geometry_.front().from.t).value;
  const double ramp = std::min(static_law_.ramp_time(), std::sqrt(feed_.value / jerk));
  const double planned_speed = (to - from) / duration;
  const double speed_up = std::max(planned_speed / feed_.value, min_speed_share);
  const double fine = static_law_.fineness(part);
  const double unit = std::min(ramp / ramp_cells / speed_up, static_law_.duration() / stretch_cells) / fine;
  const double most = duration / std::ceil(std::max(fine * turn_of(geometry_, from, to) / cell_turn, 1.0));
  std::vector<double> times;
  double t = 0;
  while (t < duration) {
    const double away = std::max(std::min(t, duration - t) - level_after * ramp, 0.0);
    t += std::max(std::min(unit + growth * away, most * (1 + 1e-9)), min_time_);
    times.push_back(t);
  }
  double reached = from;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool end = i + 1 == times.size();
    const Motion1d at = static_law_.at(start + times[i] * duration / t);
    const double offset = end ? to : at.s - begin;
    if (offset > reached) {
      cells_.push_back({offset - reached, reached, index});
      nodes_.push_back({std::max(at.v, 0.0), at.a});
      reached = offset;
    }
  }
  return to;
}

PathPoint JerkLaw::point_at(double s) {
  while (at_ > 0 && geometry_[at_].offset > s) {
    --at_;
  }
  while (at_ + 1 < geometry_.size() && geometry_[at_ + 1].offset <= s) {
    ++at_;
  }
  const PathCell& cell = geometry_[at_];
  const double w = std::clamp((s - cell.offset) / cell.length, 0.0, 1.0);
  const double first = (1 - w) * (1 - 2 * w);
  const double second = 4 * w * (1 - w);
  const double third = w * (2 * w - 1);
  const auto mix = [&](Vec3 PathPoint::*of) -> Vec3 {
    return first * (cell.from.*of) + second * (cell.middle.*of) + third * (cell.to.*of);
  };
  return {mix(&PathPoint::t), mix(&PathPoint::c), mix(&PathPoint::d)};
}

PlaceLimits JerkLaw::limits_at(double s) {
  const PathPoint point = point_at(s);
  const double speed = std::min(feed_.value, axis_share(axes_.velocity, point.t).value);
  return {point, straight_, speed, axes_.acceleration, jerk_of(loaded_)};
}

void JerkLaw::add_places(const Cell& cell) {
  SolverCell solver{cell.length, places_.size(), 0};
  if (straight_) {
    const PlaceLimits limits = limits_at(cell.offset);
    if (cell.offset == 0) {
      places_.push_back({0, limits});
    }
    places_.push_back({0.5, limits});
    places_.push_back({1, limits});
  } else {
    point_at(cell.offset);
    const std::size_t from = at_;
    point_at(cell.offset + cell.length);
    const int parts = at_ == from ? 2 : 4;
    for (int k = 0; k <= parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      places_.push_back({share, limits_at(cell.offset + share * cell.length)});
    }
  }
  solver.last = places_.size();
  solver_cells_.push_back(solver);
}

void JerkLaw::fill_places(std::size_t first, std::size_t last) {
  solver_cells_.clear();
  places_.clear();
  for (std::size_t i = first; i < last; ++i) {
    if (i == first || cells_[i].element != loaded_) {
      load_element(cells_[i].element);
    }
    add_places(cells_[i]);
  }
}

void JerkLaw::slow_nodes(double factor) {
  for (LawNode& node : nodes_) {
    node.v /= factor;
    node.a /= factor * factor;
  }
}

/// Makes the first law slower where it does not keep all limits strictly: around these places, and only if
/// that does not end, all over.
void JerkLaw::start_strictly(std::uint32_t first, std::uint32_t last) {
  constexpr double slower = 1.15;
  constexpr int max_rounds = 60;
  constexpr int local_rounds = 24;
  for (int round = 0; round < max_rounds; ++round) {
    if (round < local_rounds) {
      static_law_.plan();
      cut_cells(first, last);
    }
    slow_nodes(slower);
    if (!lower_exceeded()) {
      return;
    }
  }
}

/// Lowers the first law where the limits of a cell are not kept strictly; whether there are such cells.
bool JerkLaw::lower_exceeded() {
  bool any = false;
  double begin = 0;
  double last_lowered = -1;
  for (std::size_t i = 0; i < cells_.size(); i += jerk_window_cells) {
    const std::size_t end = std::min(i + jerk_window_cells, cells_.size());
    fill_places(i, end);
    for (std::size_t k = i; k < end; begin += cells_[k++].length) {
      if (!JerkSolver::keeps_limits(solver_cells_[k - i], places_, &nodes_[k])) {
        any = true;
        last_lowered = static_law_.lower_at(begin + cells_[k].length / 2, last_lowered);
      }
    }
  }
  return any;
}

void JerkLaw::improve(ProgressSteps& steps) {
  for (std::size_t i = 0; i < cells_.size();) {
    std::size_t end = i;
    double time = 0;
    while (end < cells_.size() &&
           (end < i + jerk_window_cells || time < window_ramps * static_law_.ramp_time())) {
      time += CellMotion::through(cells_[end].length, nodes_[end].v, nodes_[end].a, nodes_[end + 1].v,
                                  nodes_[end + 1].a)
                  .time;
      ++end;
    }
    fill_places(i, end);
    solver_.improve(solver_cells_, places_, &nodes_[i]);
    steps.at(builder_.path().segment(cells_[i].element));
    i = end == cells_.size() ? end : i + (end - i) * 2 / 3;
  }
}

double JerkLaw::time() const {
  double sum = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    sum += CellMotion::through(cells_[i].length, nodes_[i].v, nodes_[i].a, nodes_[i + 1].v, nodes_[i + 1].a)
               .time;
  }
  return sum;
}

/// The first law itself: where nothing turns no other is faster. Its pieces run over several elements.
void JerkLaw::add_planned(std::uint32_t first, std::uint32_t last) {
  std::uint32_t element = first;
  double begin = 0;
  const std::vector<StaticLaw::Phase>& phases = static_law_.phases();
  for (std::size_t i = 0; i + 1 < phases.size(); ++i) {
    const StaticLaw::Phase& phase = phases[i];
    while (element + 1 < last && begin + law_length(builder_.path(), element) <= phase.at.s) {
      begin += law_length(builder_.path(), element++);
    }
    const Cause cause = planned_cause(static_law_.straight_element(element), phase.jerk, phase.at);
    builder_.add_piece({0, phase.at.s - begin, phase.at.v, phase.at.a, phase.jerk, element, cause},
                       phases[i + 1].time - phase.time);
  }
}

Cause JerkLaw::planned_cause(const PlanElement& element, double jerk, const Motion1d& at) const {
  const MotionLimits limits = element.limits();
  const double least = 1e-9 * limits.acceleration.value;
  if (jerk == 0 && std::abs(at.a) < least) {
    return limits.speed.cause;
  }
  if (at.a < -least || (at.a < least && jerk < 0)) {
    return {CauseKind::ramp_down};
  }
  return jerk == 0 ? Cause{CauseKind::axis_acceleration, limits.acceleration.axis}
                   : Cause{CauseKind::axis_jerk, limits.jerk.axis};
}

Cause JerkLaw::cause_of(std::size_t cell, const CellMotion& m) const {
  const SolverCell& solver = solver_cells_[cell];
  double largest = 0;
  Cause cause{CauseKind::ramp_down};
  for (std::size_t p = solver.first; p < solver.last; ++p) {
    const PlaceLimits& limits = places_[p].limits;
    constexpr double full = 0.998;
    if (m.v_middle > full * limits.ceiling) {
      return feed_.value <= limits.ceiling ? feed_.cause : Cause{CauseKind::axis_velocity, limits.axis[0]};
    }
    for (int k = 0; k < limits.count; ++k) {
      const std::int8_t axis = limits.axis[static_cast<std::size_t>(k)];
      const double acceleration = std::abs(limits.acceleration(k, m.v_middle, m.a_middle));
      const double jerk =
          std::max(std::abs(limits.jerk(k, m.v0, m.a0, m.j1)), std::abs(limits.jerk(k, m.v1, m.a1, m.j2)));
      if (acceleration > largest) {
        largest = acceleration;
        cause = {CauseKind::axis_acceleration, axis};
      }
      if (jerk > largest) {
        largest = jerk;
        cause = {CauseKind::axis_jerk, axis};
      }
    }
  }
  const bool slows = m.a_middle < 0 && m.v1 < m.v0;
  return slows ? Cause{CauseKind::ramp_down} : cause;
}

void JerkLaw::add_half(const Cell& cell, const Motion1d& from, double jerk, double time, Cause cause) {
  builder_.add_piece({0, cell.offset + from.s, from.v, from.a, jerk, cell.element, cause}, time);
  const double crest = jerk < 0 ? std::clamp(-from.a / (jerk * time), 0.0, 1.0) : 0;  // of the speed
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0, crest}) {
    const Motion1d at = advance(from, jerk, share * time);
    const PlaceLimits limits = limits_at(cell.offset + at.s);
    excess_ = std::max(excess_, at.v / limits.ceiling);
    for (int k = 0; k < limits.count; ++k) {
      excess_ = std::max({excess_, std::sqrt(std::abs(limits.acceleration(k, at.v, at.a))),
                          std::cbrt(std::abs(limits.jerk(k, at.v, at.a, jerk)))});
    }
  }
}

void JerkLaw::add_pieces(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const Cell& cell = cells_[i];
    if (cell.element != loaded_ || i == first) {
      load_element(cell.element, 2);
    }
    const CellMotion m =
        CellMotion::through(cell.length, nodes_[i].v, nodes_[i].a, nodes_[i + 1].v, nodes_[i + 1].a);
    const Cause cause = cause_of(i - first, m);
    const Motion1d from{0, m.v0, m.a0};
    add_half(cell, from, m.j1, m.time / 2, cause);
    add_half(cell, advance(from, m.j1, m.time / 2), m.j2, m.time / 2, cause);
  }
}

}  // namespace feedscope
