#include "core/models/optimal/static_law.h"

#include <algorithm>
#include <cmath>

#include "core/base/roots.h"
#include "core/trajectory/stretch.h"

namespace feedscope {
namespace {

/// Shares of the limits used on curves: acceleration by turning; jerk by turning steadily and by turning
/// while speeding up; the rest along the path.
constexpr double turning = 0.4;
constexpr double along = 0.5;
constexpr double turning_jerk = 0.25;

/// Largest ratio of static speeds within one part of a curve.
constexpr double speed_ratio = 1.5;
/// Share of its speed at which a part is passed that was too fast.
constexpr double slower = 0.8;
/// Factor of its number of cells then.
constexpr double finer = 1.5;

/// Largest parts of the derivatives by axis over some cells.
struct Largest {
  Vec3 t = Vec3::Zero();
  Vec3 c = Vec3::Zero();
  Vec3 d = Vec3::Zero();

  void add(const PathCell& cell) {
    for (const PathPoint* at : {&cell.from, &cell.middle, &cell.to}) {
      t = t.cwiseMax(at->t.cwiseAbs());
      c = c.cwiseMax(at->c.cwiseAbs());
      d = d.cwiseMax(at->d.cwiseAbs());
    }
  }
};

SpeedBound static_speed(const Largest& of, const SpeedBound& feed, const AxisVectors& axes,
                        const Vec3& jerk) {
  SpeedBound speed = feed;
  const AxisBound velocity = axis_share(axes.velocity, of.t);
  const AxisBound radial = axis_share(turning * axes.acceleration, of.c);
  const AxisBound steady = axis_share(turning_jerk * jerk, of.d);
  speed.lower(velocity.value, {CauseKind::axis_velocity, velocity.axis});
  speed.lower(std::sqrt(radial.value), {CauseKind::axis_acceleration, radial.axis});
  speed.lower(std::cbrt(steady.value), {CauseKind::axis_jerk, steady.axis});
  return speed;
}

}  // namespace

void StaticLaw::clear() {
  parts_.clear();
  begins_.clear();
  fineness_.clear();
  ends_span_.clear();
  length_ = largest_jerk_ = 0;
  straight_ = true;
}

double StaticLaw::time_of(const std::vector<PathCell>& cells, const SpeedBound& feed, const AxisVectors& axes,
                          const Vec3& jerk) {
  double time = 0;
  for (const PathCell& cell : cells) {
    Largest here;
    here.add(cell);
    time += cell.length / static_speed(here, feed, axes, jerk).value;
  }
  return time;
}

void StaticLaw::add_span(const std::vector<PathCell>& cells, const SpeedBound& feed, const AxisVectors& axes,
                         const Vec3& jerk) {
  straight_ = straight_ && all_straight(cells);
  const PathCell* const end = cells.data() + cells.size();
  double least = 0;
  double most = 0;
  const PathCell* first = cells.data();
  for (const PathCell* cell = first; cell != end; ++cell) {
    Largest here;
    here.add(*cell);
    const double speed = static_speed(here, feed, axes, jerk).value;
    if (cell != first && (speed > speed_ratio * least || most > speed_ratio * speed)) {
      add_part(first, cell, feed, axes, jerk);
      first = cell;
    }
    least = cell == first ? speed : std::min(least, speed);
    most = cell == first ? speed : std::max(most, speed);
  }
  add_part(first, end, feed, axes, jerk);
  ends_span_.back() = 1;
}

void StaticLaw::add_part(const PathCell* first, const PathCell* last, const SpeedBound& feed,
                         const AxisVectors& axes, const Vec3& jerk) {
  PlanElement part;
  MotionLimits limits;
  Largest largest;
  for (const PathCell* cell = first; cell != last; ++cell) {
    part.length += cell->length;
    largest.add(*cell);
  }
  if (all_straight({first, last})) {
    limits.speed = feed;
    const AxisBound velocity = axis_share(axes.velocity, largest.t);
    limits.speed.lower(velocity.value, {CauseKind::axis_velocity, velocity.axis});
    limits.acceleration = axis_share(axes.acceleration, largest.t);
    limits.jerk = axis_share(jerk, largest.t);
  } else {
    limits.speed = static_speed(largest, feed, axes, jerk);
    const AxisBound mixed = axis_share(turning_jerk * jerk, 3 * limits.speed.value * largest.c);
    limits.acceleration = axis_share(along * axes.acceleration, largest.t);
    limits.acceleration.value = std::min(limits.acceleration.value, mixed.value);
    limits.jerk = axis_share(along * jerk, largest.t);
  }
  part.set_limits(limits);
  begins_.push_back(length_);
  fineness_.push_back(1);
  ends_span_.push_back(0);
  length_ += part.length;
  parts_.push_back(part);
  largest_jerk_ = std::max(largest_jerk_, jerk.maxCoeff());
}

double StaticLaw::lower_at(double s, double lowered) {
  const auto after = std::upper_bound(begins_.begin(), begins_.end(), s);
  const std::size_t part =
      after == begins_.begin() ? 0 : static_cast<std::size_t>(after - begins_.begin()) - 1;
  if (begins_[part] == lowered) {
    return lowered;
  }
  MotionLimits limits = parts_[part].limits();
  limits.speed.value *= slower;
  limits.acceleration.value *= slower * slower;
  limits.jerk.value *= slower * slower * slower;
  parts_[part].set_limits(limits);
  fineness_[part] *= finer;
  return begins_[part];
}

void StaticLaw::plan() {
  std::vector<SpeedBound> ceilings(parts_.size() + 1);
  for (std::size_t j = 1; j < parts_.size(); ++j) {
    ceilings[j] = parts_[j].speed();
    ceilings[j].lower(parts_[j - 1].speed().value, parts_[j - 1].speed().cause);
  }
  lay_phases(plan_nodes(parts_, ceilings));
}

void StaticLaw::lay_phases(const std::vector<PlanNode>& nodes) {
  phases_.clear();
  Motion1d at;
  double time = 0;
  double quickest = std::numeric_limits<double>::infinity();
  double top = 0;
  double end = 0;
  for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
    const SpanLimits span = span_limits(parts_, nodes[n].junction, nodes[n + 1].junction);
    const SpeedProfile profile = profile_to(nodes[n + 1].speed, span, at.v, 0);
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
  ramp_time_ = std::min(quickest, std::sqrt(top / largest_jerk_));
  phase_ = 0;
}

Motion1d StaticLaw::at(double time) {
  while (phase_ + 2 < phases_.size() && phases_[phase_ + 1].time <= time) {
    ++phase_;
  }
  const Phase& phase = phases_[phase_];
  return advance(phase.at, phase.jerk, time - phase.time);
}

double StaticLaw::time_at(double s) {
  while (phase_ + 2 < phases_.size() && phases_[phase_ + 1].at.s <= s) {
    ++phase_;
  }
  const Phase& phase = phases_[phase_];
  constexpr int halvings = 60;
  const Bracket found = halve({0, phases_[phase_ + 1].time - phase.time}, halvings,
                              [&](double time) { return advance(phase.at, phase.jerk, time).s < s; });
  return phase.time + found.high;
}

}  // namespace feedscope
