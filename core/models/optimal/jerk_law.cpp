#include "core/models/optimal/jerk_law.h"

#include <algorithm>
#include <cmath>

#include "core/blend/junction.h"

namespace feedscope {
namespace {

constexpr int fineness = 2;            ///< of the geometry, as in CellRule
constexpr double same_feed = 1e-6;     ///< largest relative difference of the feeds of joined elements
constexpr double digits = 2e-16;       ///< of a path length
constexpr double rounded_jerk = 1e-4;  ///< largest share of the jerk from rounding of a cell's length
constexpr double ramp_cells = 5;       ///< cells in the time of the shortest ramp
constexpr double stretch_cells = 20;   ///< least number of cells of a stretch
constexpr double growth = 0.4;         ///< of cells by time, away from places where the law may change
/// Share down to which the speed of the first law counts for the duration of cells, where it is slower than
/// the feed.
constexpr double min_speed_share = 0.3;
constexpr double level_after = 2;  ///< ramp times within which cells stay short
/// Step by which the law is slowed down, which does not depend on the rounding of path lengths.
constexpr double excess_step = 1e-4;
constexpr double cell_turn = 0.15;  ///< [rad]
constexpr std::size_t jerk_window_cells = 16384;
/// Largest number of times that a law is searched again on finer cells: halved where their two jerks differ
/// by more than this share of the largest. Where times must grow by more than slight_excess to keep the
/// limits between the checked places, the limits there are lowered by as much.
constexpr int max_refinements = 2;
constexpr double even_jerk = 0.2;
constexpr double slight_excess = 1e-5;
constexpr double refined_mu = 6e-3;  ///< first weight of the barriers then

/// Turn of the cells that begin in [from, to) [rad].
double turn_of(const std::vector<PathCell>& cells, double from, double to) {
  const auto before = [](const PathCell& cell, double offset) { return cell.offset < offset; };
  double turn = 0;
  for (auto cell = std::lower_bound(cells.begin(), cells.end(), from, before);
       cell != cells.end() && cell->offset < to; ++cell) {
    turn += cell->middle.c.norm() * cell->length;
  }
  return turn;
}

/// Place where half of the time is over [mm].
double middle_of(const CellMotion& m) {
  return advance({0, m.v0, m.a0}, m.j1, m.time / 2).s;
}

}  // namespace

JerkLaw::JerkLaw(const AxisVectors& axes, TrajectoryBuilder& builder) : axes_(axes), builder_(builder) {
  rule_.fineness = fineness;
  rule_.acceleration = axes.acceleration;
  rule_.jerk = axes.jerk.cwiseMin(axes.blend_jerk);
}

void JerkLaw::run(std::uint32_t first, std::uint32_t last, ProgressSteps& steps) {
  steps.at(builder_.path().segment(first));
  const TrajectoryBuilder::Mark start = builder_.mark();
  excess_ = 1;
  element_ = first;
  element_begin_ = 0;
  join_elements(first, last);
  plan();
  const double planned = static_law_.duration();
  start_strictly();
  improve(JerkSolver::first_mu, steps);
  for (int round = 0; round < max_refinements && refine(); ++round) {
    improve(refined_mu, steps);
  }
  if (static_law_.is_straight() && time() >= planned) {
    plan();
    add_planned(last);
    return;
  }
  for (std::size_t i = 0; i < cells_.size(); i += jerk_window_cells) {
    const std::size_t end = std::min(i + jerk_window_cells, cells_.size());
    fill_places(i, end);
    add_pieces(i, end, last);
  }
  if (excess_ > 1) {
    builder_.slow_down(start, std::ceil(excess_ / excess_step) * excess_step);
  }
}

const Vec3& JerkLaw::jerk_of(std::uint32_t index) const {
  return builder_.path().in_corner(index) ? axes_.blend_jerk : axes_.jerk;
}

/// Groups the elements [first, last) into spans. min_time_: a shorter cell would get its jerk from the
/// rounding of its length.
void JerkLaw::join_elements(std::uint32_t first, std::uint32_t last) {
  double length = 0;
  for (std::uint32_t e = first; e < last; ++e) {
    length += law_length(builder_.path(), e);
  }
  const double min_jerk = std::min(axes_.jerk.minCoeff(), axes_.blend_jerk.minCoeff());
  min_time_ = std::cbrt(digits * (1 + length) / (rounded_jerk * min_jerk));
  spans_.clear();
  loaded_ = none;
  double begin = 0;
  for (std::uint32_t e = first; e < last; ++e) {
    const Span next = span_of(e, begin);
    begin += law_length(builder_.path(), e);
    if (spans_.empty() || !join(spans_.back(), next)) {
      spans_.push_back(next);
    }
    spans_.back().length = begin - spans_.back().begin;
  }
}

JerkLaw::Span JerkLaw::span_of(std::uint32_t element, double begin) {
  geometry_.clear();
  append_element(element);
  Span span{element,
            element + 1,
            begin,
            0,
            element_ceiling(builder_.path(), element, axes_.velocity),
            0,
            all_straight(geometry_),
            geometry_.front().from.t};
  span.time = StaticLaw::time_of(geometry_, span.feed, axes_, jerk_of(element));
  return span;
}

/// Appends `next` to `span` where a line continues straight, and where one of the two is passed in less than
/// the time of a cell, so that cells need not end between them. Not where a lower feed would apply to the
/// other one as well, or be lost. Returns true if appended.
bool JerkLaw::join(Span& span, const Span& next) const {
  const double lower = 1 - same_feed;
  const bool slower = next.feed.value < lower * span.feed.value;
  const bool faster = span.feed.value < lower * next.feed.value;
  const bool goes_on = span.straight && next.straight && &jerk_of(span.first) == &jerk_of(next.first) &&
                       (next.tangent - span.tangent).norm() <= straight_angle;
  if (!(goes_on && !slower && !faster) && !(next.time < min_time_ && !slower) &&
      !(span.time < min_time_ && !faster)) {
    return false;
  }
  span.feed = span.time < next.time ? next.feed : span.feed;
  span.last = next.last;
  span.time += next.time;
  span.straight = span.straight && next.straight;
  return true;
}

void JerkLaw::append_element(std::uint32_t element) {
  stop_if_cancelled(builder_.progress());
  rule_.speed = element_ceiling(builder_.path(), element, axes_.velocity).value;
  append_cells(builder_.path(), element, rule_, geometry_);
}

/// Loads the cells of a span; lines that continue straight are one.
void JerkLaw::load_span(std::uint32_t index) {
  if (loaded_ == index) {
    return;
  }
  const Span& span = spans_[index];
  geometry_.clear();
  double begin = 0;
  for (std::uint32_t e = span.first; e < span.last; ++e) {
    const std::size_t added = geometry_.size();
    append_element(e);
    for (std::size_t i = added; i < geometry_.size(); ++i) {
      geometry_[i].offset += begin;
    }
    begin += law_length(builder_.path(), e);
    if (span.straight && added > 0) {
      geometry_.front().length = begin;
      geometry_.resize(1);
    }
  }
  feed_ = span.feed;
  straight_ = span.straight;
  loaded_ = index;
  at_ = 0;
}

void JerkLaw::plan() {
  static_law_.clear();
  for (std::uint32_t i = 0; i < spans_.size(); ++i) {
    load_span(i);
    static_law_.add_span(geometry_, feed_, axes_, jerk_of(geometry_.front().element));
  }
  static_law_.plan();
}

void JerkLaw::cut_cells() {
  static_law_.rewind();
  cells_.clear();
  nodes_.assign(1, {});
  std::size_t part = 0;
  for (std::uint32_t i = 0; i < spans_.size(); ++i) {
    load_span(i);
    const double begin = static_law_.part_begin(part);
    double reached = 0;
    for (bool ends = false; !ends; ++part) {
      ends = static_law_.ends_span(part);
      const double to = ends ? spans_[i].length : static_law_.part_end(part) - begin;
      reached = cut_part(i, begin, reached, to, part);
    }
  }
  nodes_.back() = {};
}

/// Lays cells up to `to` on the span, of about equal time near the ends of the part, longer ones away from
/// them; they turn little. Returns the end of the last one, which may be negligibly before `to` [mm].
double JerkLaw::cut_part(std::uint32_t index, double begin, double from, double to, std::size_t part) {
  const std::size_t place = static_law_.place();
  const double start = static_law_.time_at(begin + from);
  const double duration = static_law_.time_at(begin + to) - start;
  static_law_.rewind(place);
  const bool ends = to == spans_[index].length;
  if (duration < min_time_ && (!ends || from > 0)) {
    if (ends) {
      const Motion1d at = static_law_.at(start + duration);
      cells_.back().length = to - cells_.back().offset;
      nodes_.back() = {std::max(at.v, 0.0), at.a};
    }
    return from;
  }
  const double jerk = axis_share(jerk_of(geometry_.front().element), geometry_.front().from.t).value;
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
      cells_.push_back({offset - reached, reached, index, 1});
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

PlaceLimits JerkLaw::limits_at(double s, double slower) {
  const PathPoint point = point_at(s);
  const double speed = std::min(feed_.value, axis_share(axes_.velocity, point.t).value);
  return {point, straight_, speed / slower, axes_.acceleration / (slower * slower),
          jerk_of(geometry_[at_].element) / (slower * slower * slower)};
}

void JerkLaw::add_places(std::size_t index) {
  const Cell& cell = cells_[index];
  SolverCell solver{cell.length, places_.size(), 0};
  if (straight_) {
    const PlaceLimits limits = limits_at(cell.offset, cell.slower);
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
    const double middle = middle_of(motion_of(index)) / cell.length;
    for (int k = 0; k <= parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      const double at = 2 * k == parts ? middle : share;
      places_.push_back({share, limits_at(cell.offset + at * cell.length, cell.slower)});
    }
  }
  solver.last = places_.size();
  solver_cells_.push_back(solver);
}

void JerkLaw::fill_places(std::size_t first, std::size_t last) {
  solver_cells_.clear();
  places_.clear();
  for (std::size_t i = first; i < last; ++i) {
    load_span(cells_[i].span);
    add_places(i);
  }
}

void JerkLaw::slow_nodes(double factor) {
  for (LawNode& node : nodes_) {
    node.v /= factor;
    node.a /= factor * factor;
  }
}

/// Slows down the first law where it does not keep all limits strictly: around these places first and, if
/// that does not converge, everywhere.
void JerkLaw::start_strictly() {
  constexpr double slower = 1.15;
  constexpr int max_rounds = 60;
  constexpr int local_rounds = 24;
  for (int round = 0; round < max_rounds; ++round) {
    if (round < local_rounds) {
      static_law_.plan();
      cut_cells();
    }
    slow_nodes(slower);
    if (!lower_exceeded()) {
      return;
    }
  }
}

/// Lowers the first law where the limits of a cell are not kept strictly; true if there are such cells.
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

void JerkLaw::improve(double mu, ProgressSteps& steps) {
  for (std::size_t i = 0; i < cells_.size();) {
    const std::size_t end = std::min(i + jerk_window_cells, cells_.size());
    fill_places(i, end);
    solver_.improve(solver_cells_, places_, &nodes_[i], mu);
    steps.at(builder_.path().segment(spans_[cells_[i].span].first));
    i = end == cells_.size() ? end : i + jerk_window_cells * 2 / 3;
  }
}

CellMotion JerkLaw::motion_of(std::size_t cell) const {
  return CellMotion::through(cells_[cell].length, nodes_[cell].v, nodes_[cell].a, nodes_[cell + 1].v,
                             nodes_[cell + 1].a);
}

/// Halves cells that are too coarse for the law found and lowers limits that it exceeds in between. The law
/// stays the same, slowed down until it keeps all of them strictly. True if there are such cells.
bool JerkLaw::refine() {
  finer_cells_.clear();
  finer_nodes_.assign(1, nodes_.front());
  bool any = false;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Cell cell = cells_[i];
    load_span(cell.span);
    const CellMotion m = motion_of(i);
    const double excess = excess_of(cell, m);
    if (excess > 1 + slight_excess) {
      cell.slower *= excess;
      any = true;
    }
    const double half = middle_of(m);
    if (is_coarse(cell, m) && half > 0 && half < cell.length) {
      any = true;
      finer_cells_.push_back({half, cell.offset, cell.span, cell.slower});
      finer_nodes_.push_back({m.v_middle, m.a_middle});
      cell = {cell.length - half, cell.offset + half, cell.span, cell.slower};
    }
    finer_cells_.push_back(cell);
    finer_nodes_.push_back(nodes_[i + 1]);
  }
  cells_.swap(finer_cells_);
  nodes_.swap(finer_nodes_);
  if (any) {
    slow_strictly();
  }
  return any;
}

void JerkLaw::slow_strictly() {
  constexpr double strictly = 1e-3;
  double factor = 1;
  for (std::size_t i = 0; i < cells_.size(); i += jerk_window_cells) {
    const std::size_t end = std::min(i + jerk_window_cells, cells_.size());
    fill_places(i, end);
    for (std::size_t k = i; k < end; ++k) {
      const SolverCell& cell = solver_cells_[k - i];
      factor = std::max(factor,
                        cell_excess(motion_of(k), places_.data() + cell.first, places_.data() + cell.last));
    }
  }
  slow_nodes(factor * (1 + strictly));
}

/// True if the jerk changes much in the middle of a cell, so that it should change elsewhere.
bool JerkLaw::is_coarse(const Cell& cell, const CellMotion& motion) {
  if (motion.time < 2 * min_time_) {
    return false;
  }
  const PlaceLimits limits = limits_at(cell.offset + cell.length / 2);
  return std::abs(motion.j2 - motion.j1) > even_jerk * limits.jerk_along();
}

double JerkLaw::time() const {
  double sum = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    sum += motion_of(i).time;
  }
  return sum;
}

/// Adds the first law itself: where nothing turns no other is faster.
void JerkLaw::add_planned(std::uint32_t last) {
  std::size_t span = 0;
  const std::vector<StaticLaw::Phase>& phases = static_law_.phases();
  for (std::size_t i = 0; i + 1 < phases.size(); ++i) {
    const StaticLaw::Phase& phase = phases[i];
    while (span + 1 < spans_.size() && spans_[span + 1].begin <= phase.at.s) {
      ++span;
    }
    const Cause cause = planned_cause(static_law_.part(span), phase.jerk, phase.at);
    add_piece(phase.at, phase.jerk, phases[i + 1].time - phase.time, cause, last);
  }
}

/// Appends a piece that begins at path length `from.s` of the stretch; it may cross several elements.
void JerkLaw::add_piece(const Motion1d& from, double jerk, double time, Cause cause, std::uint32_t last) {
  while (element_ + 1 < last && element_begin_ + law_length(builder_.path(), element_) <= from.s) {
    element_begin_ += law_length(builder_.path(), element_++);
  }
  builder_.add_piece({0, from.s - element_begin_, from.v, from.a, jerk, element_, cause}, time);
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

/// Factor, at least 1, by which time in the cell must be stretched to keep all limits: velocity falls with
/// the factor, acceleration with its square, jerk with its cube.
double JerkLaw::excess_of(const Cell& cell, const CellMotion& m) {
  const Motion1d from{0, m.v0, m.a0};
  const Motion1d middle = advance(from, m.j1, m.time / 2);
  return std::max(excess_of(cell, from, m.j1, m.time / 2), excess_of(cell, middle, m.j2, m.time / 2));
}

double JerkLaw::excess_of(const Cell& cell, const Motion1d& from, double jerk, double time) {
  double excess = 1;
  const double crest = jerk < 0 ? std::clamp(-from.a / (jerk * time), 0.0, 1.0) : 0;  // of the speed
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0, crest}) {
    const Motion1d at = advance(from, jerk, share * time);
    const PlaceLimits limits = limits_at(cell.offset + at.s);
    excess = std::max(excess, at.v / limits.ceiling);
    for (int k = 0; k < limits.count; ++k) {
      excess = std::max({excess, std::sqrt(std::abs(limits.acceleration(k, at.v, at.a))),
                         std::cbrt(std::abs(limits.jerk(k, at.v, at.a, jerk)))});
    }
  }
  return excess;
}

void JerkLaw::add_pieces(std::size_t first, std::size_t last, std::uint32_t last_element) {
  for (std::size_t i = first; i < last; ++i) {
    const Cell& cell = cells_[i];
    load_span(cell.span);
    const CellMotion m = motion_of(i);
    excess_ = std::max(excess_, excess_of(cell, m));
    const Cause cause = cause_of(i - first, m);
    const Motion1d from{spans_[cell.span].begin + cell.offset, m.v0, m.a0};
    add_piece(from, m.j1, m.time / 2, cause, last_element);
    add_piece(advance(from, m.j1, m.time / 2), m.j2, m.time / 2, cause, last_element);
  }
}

}  // namespace feedscope
