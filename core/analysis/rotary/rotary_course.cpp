#include "core/analysis/rotary/rotary_course.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/rotary/turn_law.h"
#include "core/base/units.h"
#include "core/toolpath/joint_shape.h"
#include "core/toolpath/turn_course.h"

namespace feedscope {
namespace {

AxisState motion_of(const Series& course) {
  return {course.value(), course.d1(), course.d2(), course.d3()};
}

/// Share of a line at the foot of the tip on it.
Series share_of_line(const Vec3& start, const Vec3& end, const State& state) {
  const Vec3 way = (end - start) / (end - start).squaredNorm();
  return Series((state.position - start).dot(way), state.velocity.dot(way), state.acceleration.dot(way),
                state.jerk.dot(way));
}

/// Share from `begin` that grows evenly with the path, by `slope` [1/mm].
Series even_share(double begin, double slope, const State& state) {
  return Series(begin, slope * state.speed, slope * state.tangential_acceleration,
                slope * state.tangential_jerk);
}

/// Clamps to 0 and 1, since rounding may put the course slightly outside.
Series within_segment(Series share) {
  share += Series(std::clamp(share.value(), 0.0, 1.0) - share.value());
  return share;
}

/// Progress of a rotation about the arc's axis, for arcs of several turns; `near`: an approximate share.
double share_of_arc(const Arc& arc, const Vec3& position, double near) {
  const Vec3 from = position - arc.center;
  const double angle = std::atan2(from.dot(arc.y), from.dot(arc.x));
  const double turns = std::round((near * arc.sweep - angle) / (2 * units::pi));
  return (angle + turns * 2 * units::pi) / arc.sweep;
}

/// Corner that contains element `i`; null if none.
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

/// Sets the start of each turn, at its segment or the next one that runs, and the stops of the tip.
void RotaryCourse::set_starts() {
  constexpr double standstill = 1e-9;  // [mm/s]; also [mm] from the start of the element
  auto event = events_.begin();
  for (const Piece& piece : trajectory_->pieces()) {
    const std::uint32_t segment = trajectory_->path().segment(piece.element);
    if (segment > 0 && piece.law != Law::filtered && piece.v < standstill && piece.q < standstill &&
        !trajectory_->path().in_corner(piece.element)) {
      stops_.push_back(segment - 1);
    }
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
  Angles angles{};
  if (after == events_.begin()) {
    // Angles at the start of the first turn; not 0 if the part is turned on the machine.
    std::ranges::copy(events_.front().along ? path().segment_turns[events_.front().index].from
                                            : path().rotary_turns[events_.front().index].from,
                      angles.begin());
  } else {
    const Event& event = *std::prev(after);
    angles = event.along ? along(path().segment_turns[event.index], way)
                         : turning(path().rotary_turns[event.index], state.time - event.start);
  }
  add_joints(way, angles);
  const auto swings = [&] {  // the axes keep the tip in place in a separate turn
    return after != events_.begin() && !std::prev(after)->along && std::prev(after)->segment == way.segment &&
           path().rotary_turns[std::prev(after)->index].at_tip;
  };
  RotarySample sample;
  for (std::size_t i = 0; i < rotary_names.size(); ++i) {
    sample.rotary[i] = has(rotary_names[i]) ? motion_of(angles[i]) : AxisState::unknown();
  }
  const SegmentTurn* turn = knows_linear() ? path().segment_turn(way.segment) : nullptr;
  if ((turn != nullptr && turn->at_tip) || (knows_linear() && swings())) {
    sample.linear = linear_axes(state, angles);
  }
  return sample;
}

Vec3 RotaryCourse::tool_direction(const State& state) const {
  return path().part.turn.transpose() * feedscope::tool_direction(chain_, at(state).angles());
}

Vec3 RotaryCourse::slides(const State& state) const {
  const std::array<double, 3> angles = at(state).angles();
  std::vector<double> turned;
  for (const std::size_t k : chain_.rotary()) {
    turned.push_back(angles[rotary_place(chain_.axes()[k].name)]);
  }
  const PartOnMachine& part = path().part;
  const std::vector<double> places =
      chain_.places(part.turn * state.position + part.zero, turned, part.tool_length);
  Vec3 slides = Vec3::Zero();
  for (const std::size_t k : chain_.linear()) {
    slides[chain_.axes()[k].name - 'X'] = places[k];
  }
  return slides;
}

/// Axes that carry the part turn the part, not the tool.
Vec3 RotaryCourse::tool_on_machine(const State& state) const {
  std::array<double, 3> angles = at(state).angles();
  for (const std::size_t k : chain_.rotary()) {
    if (chain_.axes()[k].carries_part) {
      angles[rotary_place(chain_.axes()[k].name)] = 0;
    }
  }
  return feedscope::tool_direction(chain_, angles);
}

std::array<AxisState, 3> RotaryCourse::linear_axes(const State& state, const Angles& angles) const {
  CurvePoint tip;
  tip.position = state.position;
  tip.d1 = state.velocity;
  tip.d2 = state.acceleration;
  tip.d3 = state.jerk;
  std::vector<Series> turned;
  for (const std::size_t k : chain_.rotary()) {
    turned.push_back(angles[rotary_place(chain_.axes()[k].name)]);
  }
  const std::vector<Series> all =
      chain_.courses(tip_on_machine(path().part, tip), turned, path().part.tool_length);
  std::array<AxisState, 3> linear;
  for (const std::size_t k : chain_.linear()) {
    linear[static_cast<std::size_t>(chain_.axes()[k].name - 'X')] = motion_of(all[k]);
  }
  return linear;
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
  if (segment.kind == SegmentKind::arc &&
      (blended.is_executed() || blended.kind(state.element) == ElementKind::arc)) {
    const double near = blended.is_executed() ? 0.5 : done;
    const double share = share_of_arc(path().arc_of(segment), state.position, near);
    return {i, within_segment(even_share(share, 1 / segment.length, state)), true};
  }
  switch (blended.kind(state.element)) {
    case ElementKind::dwell:
      return {i, 0, false};
    case ElementKind::blend:
    case ElementKind::connecting_arc: {
      const double transition = blended.corner_transition(blended.index(state.element));
      const bool behind = done >= 0.5 && i + 1 < path().segments.size();
      const std::uint32_t on = behind ? i + 1 : i;
      const double whole = path().segments[on].length;
      if (!(whole > 0 && length > 0)) {
        return {on, 1, false};
      }
      const double from_corner = transition * std::abs(2 * done - 1);
      const double way = behind ? from_corner : whole - from_corner;
      return {on, within_segment(even_share(way / whole, 2 * transition / length / whole, state)), true};
    }
    case ElementKind::line:
    case ElementKind::curve:
      if (line) {
        return on_lines(i, state);
      }
      break;
    case ElementKind::arc:
    case ElementKind::filtered:
    case ElementKind::fitted:
      break;
  }
  return length > 0 ? Way{i, even_share(done, 1 / length, state), true} : Way{i, done, false};
}

/// Nearest place on line `i`, or if that is its end, on one of the lines after it, over which a smooth curve
/// continues.
RotaryCourse::Way RotaryCourse::on_lines(std::uint32_t i, const State& state) const {
  constexpr double rounding = 1e-9;  // of a place from the end of a line [mm]
  for (;; ++i) {
    const Segment& segment = path().segments[i];
    const Series share = share_of_line(path().start_of(i), segment.end, state);
    const std::size_t next = i + std::size_t{1};
    const bool goes_on = next < path().segments.size() && path().segments[next].kind == SegmentKind::line &&
                         (state.position - segment.end).dot(path().segments[next].end - segment.end) >
                             rounding * path().segments[next].length;
    if (share.value() < 1 || !goes_on) {
      return {i, within_segment(share), true};
    }
  }
}

/// On a control's path over programmed lines: the share of a line is the nearest one; a rounded corner
/// extends from where it leaves one line to where it meets the next.
RotaryCourse::Way RotaryCourse::executed_way(const State& state, double done) const {
  const BlendedPath& blended = trajectory_->path();
  const std::uint32_t i = blended.segment(state.element);
  const RoundedCorner* corner = rounded_corner(blended, state.element);
  if (corner == nullptr) {
    return {i, within_segment(share_of_line(path().start_of(i), path().segments[i].end, state)), true};
  }
  const std::uint32_t before = corner->block;
  const std::uint32_t behind = before + 1;
  if (behind >= path().segments.size() || path().segments[before].kind != SegmentKind::line ||
      path().segments[behind].kind != SegmentKind::line) {
    return {i, even_share(done, 1 / path().segments[i].length, state), true};
  }
  const auto share_on = [&](std::uint32_t on, const Vec3& place) {
    State there;
    there.position = place;
    return within_segment(share_of_line(path().start_of(on), path().segments[on].end, there)).value();
  };
  const double begin = blended.s(corner->first);
  const double length = blended.s(corner->last + std::size_t{1}) - begin;
  const double half = 2 * (state.path_length - begin) / length;  // 1 in the middle
  const double left = share_on(before, blended.element(corner->first).start);
  const double met = share_on(behind, blended.element(corner->last).end);
  return half < 1 ? Way{before, even_share(left + (1 - left) * half, 2 * (1 - left) / length, state), true}
                  : Way{behind, even_share(met * (half - 1), 2 * met / length, state), true};
}

RotaryCourse::Angles RotaryCourse::along(const SegmentTurn& turn, const Way& way) const {
  Angles angles;
  std::ranges::copy(turn.to, angles.begin());
  if (way.segment != turn.segment) {
    return angles;
  }
  const double length = path().segments[turn.segment].length;
  const Series s = way.share * length;
  const std::vector<Series> by_path = TurnCourse(chain_, turn, length).at(s.value());
  for (std::size_t k = 0; k < by_path.size(); ++k) {
    angles[rotary_place(chain_.axes()[chain_.rotary()[k]].name)] = chained(by_path[k], s);
  }
  return angles;
}

const TurnJoint* RotaryCourse::joint_behind(std::size_t segment) const {
  return std::ranges::binary_search(stops_, segment) ? nullptr : path().turn_joint(segment);
}

/// Adds the changes by the joints at both ends of the segment.
void RotaryCourse::add_joints(const Way& way, Angles& angles) const {
  if (path().turn_joints.empty() || !way.along) {
    return;
  }
  const double length = path().segments[way.segment].length;
  const auto add = [&](const TurnJoint* joint, const Series& away) {
    for (std::size_t i = 0; joint != nullptr && i < angles.size(); ++i) {
      if (joint->step[i] != 0) {
        angles[i] += chained(joint_turn(*joint, i, away.value()), away);
      }
    }
  };
  add(joint_behind(way.segment), -((1 - way.share) * length));
  if (way.segment > 0) {
    add(joint_behind(way.segment - std::size_t{1}), way.share * length);
  }
}

RotaryCourse::Angles RotaryCourse::turning(const RotaryTurn& turn, double time) const {
  Angles angles;
  std::ranges::copy(turn.to, angles.begin());
  if (turn.law.way > 0 && turn.great_circle) {
    SegmentTurn whole;
    whole.from = turn.from;
    whole.to = turn.to;
    whole.great_circle = true;
    const RestToRestPlace at =
        rest_to_rest_at(time, turn.law.way, turn.law.velocity, turn.law.acceleration, turn.law.jerk);
    const Series s(at.way, at.velocity, at.acceleration, at.jerk);
    const std::vector<Series> by_way = TurnCourse(chain_, whole, turn.law.way).at(at.way);
    for (std::size_t k = 0; k < by_way.size(); ++k) {
      angles[rotary_place(chain_.axes()[chain_.rotary()[k]].name)] = chained(by_way[k], s);
    }
    return angles;
  }
  for (const RotaryAxis& axis : axes_) {
    angles[rotary_place(axis.name)] = TurnLaw(turn, axes_, axis).at(time);
  }
  return angles;
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
