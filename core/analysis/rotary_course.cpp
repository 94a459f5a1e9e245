#include "core/analysis/rotary_course.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/units.h"
#include "core/toolpath/turn_course.h"
#include "core/toolpath/turn_limiter.h"

namespace feedscope {
namespace {

std::size_t place_of(const RotaryAxis& axis) {
  return rotary_names.find(axis.name);
}

/// How far a turn about the arc's axis has gone, of an arc that may turn several times; `near`: a share that
/// is close.
double share_of_arc(const Arc& arc, const Vec3& position, double near) {
  const Vec3 from = position - arc.center;
  const double angle = std::atan2(from.dot(arc.y), from.dot(arc.x));
  const double turns = std::round((near * arc.sweep - angle) / (2 * units::pi));
  return (angle + turns * 2 * units::pi) / arc.sweep;
}

/// That element `i` is part of; null if of none.
const RoundedCorner* rounded_corner(const BlendedPath& path, std::uint32_t i) {
  std::size_t low = 0;
  std::size_t high = path.rounded_count();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (path.rounded(middle).last < i) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < path.rounded_count() && path.rounded(low).first <= i ? &path.rounded(low) : nullptr;
}

}  // namespace

RotaryCourse::RotaryCourse(std::shared_ptr<const Trajectory> trajectory, const Machine& machine)
    : trajectory_(std::move(trajectory)),
      axes_(machine.kinematics.rotary),
      chain_(chain_of(machine.kinematics)) {
  for (std::size_t i = 0; i < path().rotary_turns.size(); ++i) {
    events_.push_back({path().rotary_turns[i].segment, trajectory_->duration(), i, false});
  }
  for (std::size_t i = 0; i < path().segment_turns.size(); ++i) {
    events_.push_back({path().segment_turns[i].segment, 0, i, true});
  }
  std::ranges::stable_sort(events_, {}, &Event::segment);
  set_starts();
}

/// When the segment of each turn, or the next one that the control runs, begins.
void RotaryCourse::set_starts() {
  auto event = events_.begin();
  for (const Piece& piece : trajectory_->pieces()) {
    const std::uint32_t segment = trajectory_->path().segment(piece.element);
    for (; event != events_.end() && event->segment <= segment; ++event) {
      event->start = piece.time;
    }
  }
}

bool RotaryCourse::has(char axis) const {
  return std::ranges::find(axes_, axis, &RotaryAxis::name) != axes_.end();
}

RotarySample RotaryCourse::at(const State& state) const {
  const Way way = trajectory_->pieces().empty() ? Way() : way_of(state);
  const auto after = std::ranges::upper_bound(events_, way.segment, {}, &Event::segment);
  RotarySample sample;
  if (after != events_.begin()) {
    const Event& event = *std::prev(after);
    sample = event.along ? along(path().segment_turns[event.index], way, state.speed)
                         : turning(path().rotary_turns[event.index], state.time - event.start);
  }
  add_joints(way, state.speed, sample);
  for (std::size_t i = 0; i < rotary_names.size(); ++i) {
    if (!has(rotary_names[i])) {
      sample.angle[i] = sample.velocity[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  return sample;
}

Vec3 RotaryCourse::tool_direction(const State& state) const {
  return path().part.turn.transpose() * feedscope::tool_direction(chain_, at(state).angle);
}

std::array<double, 3> RotaryCourse::linear_velocity(const State& state, const RotarySample& sample) const {
  CurvePoint tip;
  tip.position = state.position;
  tip.d1 = state.velocity;
  tip.d2 = tip.d3 = Vec3::Zero();
  std::vector<Series> angles;
  for (const std::size_t k : chain_.rotary()) {
    const std::size_t i = rotary_names.find(chain_.axes()[k].name);
    angles.emplace_back(sample.angle[i], sample.velocity[i], 0, 0);
  }
  const std::vector<Series> all =
      chain_.courses(tip_on_machine(path().part, tip), angles, path().part.tool_length);
  std::array<double, 3> velocity{};
  for (const std::size_t k : chain_.linear()) {
    velocity[static_cast<std::size_t>(chain_.axes()[k].name - 'X')] = all[k].d1();
  }
  return velocity;
}

RotaryCourse::Way RotaryCourse::way_of(const State& state) const {
  const BlendedPath& blended = trajectory_->path();
  const std::uint32_t i = blended.segment(state.element);
  const Segment& segment = path().segments[i];
  const double q = state.path_length - blended.s(state.element);
  const double length = blended.length(state.element);
  const double done = length > 0 ? std::clamp(q / length, 0.0, 1.0) : 0;
  const bool line = segment.kind == SegmentKind::line;
  if (blended.is_executed() && line && length > 0) {
    return executed_way(state, done);
  }
  if (blended.is_executed() && segment.kind == SegmentKind::arc) {
    const double share = share_of_arc(path().arc_of(segment), state.position, 0.5);
    return {i, std::clamp(share, 0.0, 1.0), 1 / segment.length};
  }
  switch (blended.kind(state.element)) {
    case ElementKind::dwell:
      return {i, 0, 0};
    case ElementKind::blend:
    case ElementKind::connecting_arc: {
      const double transition = blended.corner_transition(blended.index(state.element));
      const bool behind = done >= 0.5 && i + 1 < path().segments.size();
      const std::uint32_t on = behind ? i + 1 : i;
      const double whole = path().segments[on].length;
      const double from_corner = transition * std::abs(2 * done - 1);
      const double way = behind ? from_corner : whole - from_corner;
      return whole > 0 && length > 0
                 ? Way{on, std::clamp(way / whole, 0.0, 1.0), 2 * transition / length / whole}
                 : Way{on, 1, 0};
    }
    case ElementKind::line:
    case ElementKind::curve: {
      if (!line) {
        break;
      }
      return on_lines(i, state.position);
    }
    case ElementKind::arc:
      if (segment.kind == SegmentKind::arc) {
        const double share = share_of_arc(path().arc_of(segment), state.position, done);
        return {i, std::clamp(share, 0.0, 1.0), 1 / segment.length};
      }
      break;
    case ElementKind::filtered:
    case ElementKind::fitted:
      break;
  }
  return {i, done, length > 0 ? 1 / length : 0};
}

/// The nearest place on line `i`, or where that is its end, on one of the lines behind it, over which a
/// smooth curve goes on.
RotaryCourse::Way RotaryCourse::on_lines(std::uint32_t i, const Vec3& position) const {
  for (;; ++i) {
    const Segment& segment = path().segments[i];
    const Vec3& start = path().start_of(i);
    const double share = (position - start).dot(segment.end - start) / (segment.length * segment.length);
    const std::size_t next = i + std::size_t{1};
    const bool goes_on = next < path().segments.size() && path().segments[next].kind == SegmentKind::line &&
                         (position - segment.end).dot(path().segments[next].end - segment.end) > 0;
    if (share < 1 || !goes_on) {
      return {i, std::clamp(share, 0.0, 1.0), 1 / segment.length};
    }
  }
}

/// On what a control makes of programmed lines: the share of a line is the nearest one, and a rounded corner
/// goes from where it leaves one line to where it meets the next.
RotaryCourse::Way RotaryCourse::executed_way(const State& state, double done) const {
  const BlendedPath& blended = trajectory_->path();
  const std::uint32_t i = blended.segment(state.element);
  const auto share_on = [&](std::uint32_t on, const Vec3& place) {
    const Vec3 way = path().segments[on].end - path().start_of(on);
    return std::clamp((place - path().start_of(on)).dot(way) / way.squaredNorm(), 0.0, 1.0);
  };
  const RoundedCorner* corner = rounded_corner(blended, state.element);
  if (corner == nullptr) {
    return {i, share_on(i, state.position), 1 / path().segments[i].length};
  }
  const std::uint32_t before = corner->block;
  const std::uint32_t behind = before + 1;
  if (behind >= path().segments.size() || path().segments[before].kind != SegmentKind::line ||
      path().segments[behind].kind != SegmentKind::line) {
    return {i, done, 1 / path().segments[i].length};
  }
  const double begin = blended.s(corner->first);
  const double length = blended.s(corner->last + std::size_t{1}) - begin;
  const double half = 2 * (state.path_length - begin) / length;  // 1 in the middle
  const double left = share_on(before, blended.element(corner->first).start);
  const double met = share_on(behind, blended.element(corner->last).end);
  return half < 1 ? Way{before, left + (1 - left) * half, 2 * (1 - left) / length}
                  : Way{behind, met * (half - 1), 2 * met / length};
}

RotarySample RotaryCourse::along(const SegmentTurn& turn, const Way& way, double speed) const {
  RotarySample sample;
  sample.angle = turn.to;
  if (way.segment != turn.segment) {
    return sample;
  }
  const double length = path().segments[turn.segment].length;
  const std::vector<Series> angles = TurnCourse(chain_, turn, length).at(way.share * length);
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const std::size_t i = rotary_names.find(chain_.axes()[chain_.rotary()[k]].name);
    sample.angle[i] = angles[k].value();
    sample.velocity[i] = angles[k].d1() * length * way.slope * speed;
  }
  return sample;
}

/// What the joints at both ends of the segment change.
void RotaryCourse::add_joints(const Way& way, double speed, RotarySample& sample) const {
  if (path().turn_joints.empty() || !(way.slope > 0)) {
    return;
  }
  const double length = path().segments[way.segment].length;
  const auto add = [&](const TurnJoint* joint, double away) {
    for (std::size_t i = 0; joint != nullptr && i < rotary_names.size(); ++i) {
      const JointTurn turn = joint_turn(joint->step[i], joint->half, away);
      sample.angle[i] += turn.angle;
      sample.velocity[i] += turn.slope * length * way.slope * speed;
    }
  };
  add(path().turn_joint(way.segment), -(1 - way.share) * length);
  if (way.segment > 0) {
    add(path().turn_joint(way.segment - std::size_t{1}), way.share * length);
  }
}

RotarySample RotaryCourse::turning(const RotaryTurn& turn, double time) const {
  RotarySample sample;
  sample.angle = turn.to;
  double way = 0;
  for (const RotaryAxis& axis : axes_) {
    way = std::hypot(way, turn.to[place_of(axis)] - turn.from[place_of(axis)]);
  }
  double velocity = turn.feed;
  double acceleration = HUGE_VAL;
  double jerk = HUGE_VAL;
  for (const RotaryAxis& axis : axes_) {
    const double share = way > 0 ? std::abs(turn.to[place_of(axis)] - turn.from[place_of(axis)]) / way : 0;
    if (share > 0) {
      velocity = std::min(velocity, axis.velocity / share);
      acceleration = std::min(acceleration, axis.acceleration / share);
      jerk = std::min(jerk, axis.jerk / share);
    }
  }
  for (const RotaryAxis& axis : axes_) {
    const std::size_t i = place_of(axis);
    const double angle = turn.to[i] - turn.from[i];
    if (angle == 0) {
      continue;
    }
    const RestToRestPlace place =
        turn.feed > 0 ? rest_to_rest_at(time, way, velocity, acceleration, jerk)
                      : rest_to_rest_at(time, std::abs(angle), axis.velocity, axis.acceleration, axis.jerk);
    const double share = turn.feed > 0 ? angle / way : std::copysign(1, angle);
    sample.angle[i] = turn.from[i] + share * place.way;
    sample.velocity[i] = share * place.velocity;
  }
  return sample;
}

std::shared_ptr<const RotaryCourse> rotary_course_of(std::shared_ptr<const Trajectory> trajectory,
                                                     const Machine& machine) {
  const auto& path = trajectory->path().programmed();
  if (machine.kinematics.empty() || path == nullptr ||
      (path->rotary_turns.empty() && path->segment_turns.empty())) {
    return nullptr;
  }
  return std::make_shared<const RotaryCourse>(std::move(trajectory), machine);
}

}  // namespace feedscope
