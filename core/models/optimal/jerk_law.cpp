#include "core/models/optimal/jerk_law.h"

#include <algorithm>
#include <cmath>

#include "core/trajectory/stretch.h"

namespace feedscope {
namespace {

/// Shares of the limits that the first law uses on curves: acceleration by turning, jerk by turning steadily,
/// by turning and speeding up together, and what is left along the path.
constexpr double turning = 0.4;
constexpr double along = 0.5;
constexpr double turning_jerk = 0.25;

constexpr double ramp_cells = 5;      ///< cells in the time of the shortest ramp
constexpr double stretch_cells = 20;  ///< cells of a stretch at least
constexpr double growth = 0.4;        ///< of cells by time, away from where the law may change
/// Cells last longer in the first law than they will, up to this share, where it is slower than the feed.
constexpr double least_speed_share = 0.3;
constexpr double level_after = 2;   ///< ramp times within which they stay short
constexpr double cell_turn = 0.15;  ///< [rad]
constexpr std::size_t window_cells = 256;
constexpr double window_ramps = 8;  ///< a window lasts so many ramps at least

double largest_part(const PathCell& cell, int axis, Vec3 PathPoint::*of) {
  return std::max(
      {std::abs((cell.from.*of)[axis]), std::abs((cell.middle.*of)[axis]), std::abs((cell.to.*of)[axis])});
}

double turn_of(const std::vector<PathCell>& cells) {
  double turn = 0;
  for (const PathCell& cell : cells) {
    turn += cell.middle.c.norm() * cell.length;
  }
  return turn;
}

}  // namespace

JerkLaw::JerkLaw(const Toolpath& toolpath, const AxisVectors& axes, TrajectoryBuilder& builder)
    : toolpath_(toolpath), axes_(axes), builder_(builder) {
  rule_.acceleration = axes.acceleration;
  rule_.jerk = axes.jerk.cwiseMin(axes.blend_jerk);
}

void JerkLaw::run(std::uint32_t first, std::uint32_t last, ProgressSteps& steps) {
  steps.at(builder_.path().segment(first));
  const TrajectoryBuilder::Mark start = builder_.mark();
  excess_ = 1;
  plan(first, last);
  lay_phases();
  cut_cells(first, last);
  start_strictly();
  improve(steps);
  if (straight_ && time() >= planned_duration_) {
    add_planned(first);
    return;
  }
  for (std::size_t i = 0; i < cells_.size(); i += window_cells) {
    const std::size_t end = std::min(i + window_cells, cells_.size());
    fill_places(i, end);
    add_pieces(i, end);
  }
  if (excess_ > 1) {
    builder_.slow_down(start, excess_);
  }
}

const Vec3& JerkLaw::jerk_of(std::uint32_t index) const {
  return builder_.path().in_corner(index) ? axes_.blend_jerk : axes_.jerk;
}

void JerkLaw::load_element(std::uint32_t index, int fineness) {
  rule_.fineness = fineness;
  feed_ = programmed_speed(toolpath_, builder_.path().segment(index), axes_.velocity);
  rule_.speed = feed_.value;
  geometry_.clear();
  append_cells(builder_.path(), index, rule_, geometry_);
  loaded_ = index;
  at_ = 0;
}

/// Static limits, such that any ramp that keeps them keeps those of the axes.
PlanElement JerkLaw::plan_element(std::uint32_t index) {
  load_element(index);
  const Vec3& jerk = jerk_of(index);
  PlanElement element;
  element.length = builder_.path().length(index);
  MotionLimits& limits = element.limits;
  limits.speed = feed_;
  if (geometry_.front().straight) {
    const Vec3& t = geometry_.front().from.t;
    const AxisBound velocity = axis_share(axes_.velocity, t);
    limits.speed.lower(velocity.value, {CauseKind::axis_velocity, velocity.axis});
    limits.acceleration = axis_share(axes_.acceleration, t);
    limits.jerk = axis_share(jerk, t);
    return element;
  }
  Vec3 t = Vec3::Zero();
  Vec3 c = Vec3::Zero();
  Vec3 d = Vec3::Zero();
  for (const PathCell& cell : geometry_) {
    for (int j = 0; j < 3; ++j) {
      t[j] = std::max(t[j], largest_part(cell, j, &PathPoint::t));
      c[j] = std::max(c[j], largest_part(cell, j, &PathPoint::c));
      d[j] = std::max(d[j], largest_part(cell, j, &PathPoint::d));
    }
  }
  const AxisBound velocity = axis_share(axes_.velocity, t);
  const AxisBound radial = axis_share(turning * axes_.acceleration, c);
  const AxisBound steady = axis_share(turning_jerk * jerk, d);
  limits.speed.lower(velocity.value, {CauseKind::axis_velocity, velocity.axis});
  limits.speed.lower(std::sqrt(radial.value), {CauseKind::axis_acceleration, radial.axis});
  limits.speed.lower(std::cbrt(steady.value), {CauseKind::axis_jerk, steady.axis});
  const AxisBound mixed = axis_share(turning_jerk * jerk, 3 * limits.speed.value * c);
  limits.acceleration = axis_share(along * axes_.acceleration, t);
  limits.acceleration.value = std::min(limits.acceleration.value, mixed.value);
  limits.jerk = axis_share(along * jerk, t);
  return element;
}

void JerkLaw::plan(std::uint32_t first, std::uint32_t last) {
  plan_.clear();
  straight_ = true;
  for (std::uint32_t e = first; e < last; ++e) {
    plan_.push_back(plan_element(e));
    straight_ = straight_ && geometry_.front().straight;
  }
  std::vector<SpeedBound> ceilings(plan_.size() + 1);
  for (std::size_t j = 1; j < plan_.size(); ++j) {
    ceilings[j] = plan_[j].limits.speed;
    ceilings[j].lower(plan_[j - 1].limits.speed.value, plan_[j - 1].limits.speed.cause);
  }
  plan_nodes_ = plan_nodes(plan_, ceilings);
}

void JerkLaw::lay_phases() {
  phases_.clear();
  Motion1d at;
  double time = 0;
  double quickest = std::numeric_limits<double>::infinity();
  double top = 0;
  double end = 0;
  for (std::size_t n = 0; n + 1 < plan_nodes_.size(); ++n) {
    const SpanLimits span = span_limits(plan_, plan_nodes_[n].junction, plan_nodes_[n + 1].junction);
    const SpeedProfile profile = profile_to(plan_nodes_[n + 1].speed, span, at.v, 0);
    at.s = end;
    at.a = 0;
    end += span.length;
    for (const auto& phase : profile.phases) {
      if (phase.duration > 0) {
        phases_.push_back({time, phase.jerk, at});
        at = advance(at, phase.jerk, phase.duration);
        time += phase.duration;
        top = std::max(top, at.v);
        quickest = std::min(quickest, span.acceleration.value / span.jerk.value);
      }
    }
  }
  phases_.push_back({time, 0, {end, 0, 0}});
  planned_duration_ = time;
  const double jerk = axes_.jerk.maxCoeff();
  ramp_time_ = std::min(quickest, std::sqrt(top / jerk));
  phase_ = 0;
}

/// The planned motion; times in order.
Motion1d JerkLaw::planned_at(double time) {
  while (phase_ + 2 < phases_.size() && phases_[phase_ + 1].time <= time) {
    ++phase_;
  }
  const Phase& phase = phases_[phase_];
  return advance(phase.at, phase.jerk, time - phase.time);
}

/// When the planned motion reaches `s`; in order.
double JerkLaw::planned_time(double s) {
  while (phase_ + 2 < phases_.size() && phases_[phase_ + 1].at.s <= s) {
    ++phase_;
  }
  const Phase& phase = phases_[phase_];
  double low = 0;
  double high = phases_[phase_ + 1].time - phase.time;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (advance(phase.at, phase.jerk, middle).s < s ? low : high) = middle;
  }
  return phase.time + high;
}

void JerkLaw::cut_cells(std::uint32_t first, std::uint32_t last) {
  cells_.clear();
  nodes_.assign(1, {});
  double begin = 0;
  for (std::uint32_t e = first; e < last; ++e) {
    load_element(e);
    cut_element(e, begin);
    begin += builder_.path().length(e);
  }
  nodes_.back() = {};
}

/// Cells of about equal time near the ends of an element, longer ones away from them; they turn little.
void JerkLaw::cut_element(std::uint32_t index, double begin) {
  const double length = builder_.path().length(index);
  const std::size_t phase = phase_;
  const double start = planned_time(begin);
  const double duration = planned_time(begin + length) - start;
  phase_ = phase;
  const double jerk = axis_share(jerk_of(index), geometry_.front().from.t).value;
  const double ramp = std::min(ramp_time_, std::sqrt(feed_.value / jerk));
  const double planned_speed = length / duration;
  const double speed_up = std::max(planned_speed / feed_.value, least_speed_share);
  const double unit = std::min(ramp / ramp_cells / speed_up, planned_duration_ / stretch_cells);
  const double most = duration / std::ceil(std::max(turn_of(geometry_) / cell_turn, 1.0));
  std::vector<double> times;
  double t = 0;
  while (t < duration) {
    const double away = std::max(std::min(t, duration - t) - level_after * ramp, 0.0);
    t += std::min(unit + growth * away, most * (1 + 1e-9));
    times.push_back(t);
  }
  double reached = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool end = i + 1 == times.size();
    const Motion1d at = planned_at(start + times[i] * duration / t);
    const double offset = end ? length : at.s - begin;
    if (offset > reached) {
      cells_.push_back({offset - reached, reached, index});
      nodes_.push_back({std::max(at.v, 0.0), at.a});
      reached = offset;
    }
  }
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
  return {point, geometry_.front().straight, speed, axes_.acceleration, jerk_of(loaded_)};
}

void JerkLaw::add_places(const Cell& cell) {
  SolverCell solver{cell.length, places_.size(), 0};
  if (geometry_.front().straight) {
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

/// Passes the planned law slower until all limits are kept strictly.
void JerkLaw::start_strictly() {
  constexpr double slower = 1.15;
  constexpr int most_rounds = 60;
  double factor = 1;
  const auto slow = [&] {
    factor *= slower;
    for (LawNode& node : nodes_) {
      node.v /= slower;
      node.a /= slower * slower;
    }
  };
  slow();
  for (std::size_t i = 0; i < cells_.size(); i += window_cells) {
    const std::size_t end = std::min(i + window_cells, cells_.size());
    fill_places(i, end);
    for (int round = 0; round < most_rounds && !JerkSolver::keeps_limits(solver_cells_, places_, &nodes_[i]);
         ++round) {
      slow();
    }
  }
}

void JerkLaw::improve(ProgressSteps& steps) {
  for (std::size_t i = 0; i < cells_.size();) {
    std::size_t end = i;
    double time = 0;
    while (end < cells_.size() && (end < i + window_cells || time < window_ramps * ramp_time_)) {
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

/// The planned law itself: where nothing turns no other is faster. Its pieces run over several elements.
void JerkLaw::add_planned(std::uint32_t first) {
  std::uint32_t element = first;
  double begin = 0;
  for (std::size_t i = 0; i + 1 < phases_.size(); ++i) {
    const Phase& phase = phases_[i];
    while (element + 1 < first + plan_.size() && begin + builder_.path().length(element) <= phase.at.s) {
      begin += builder_.path().length(element++);
    }
    const Cause cause = planned_cause(plan_[element - first], phase.jerk, phase.at);
    builder_.add_piece({0, phase.at.s - begin, phase.at.v, phase.at.a, phase.jerk, element, cause},
                       phases_[i + 1].time - phase.time);
  }
}

Cause JerkLaw::planned_cause(const PlanElement& element, double jerk, const Motion1d& at) const {
  const MotionLimits& limits = element.limits;
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
