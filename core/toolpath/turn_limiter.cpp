#include "core/toolpath/turn_limiter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/roots.h"
#include "core/base/units.h"
#include "core/machine/contour_tolerance.h"
#include "core/toolpath/turn_course.h"

namespace feedscope {
namespace {

using Angles = std::array<double, 3>;

constexpr double share = 0.75;  // as turning_share of limits/segment_limits.h
constexpr std::size_t linear_count = coordinate_names.size();

/// Share of a block over which a joint reaches that shapes its whole course; not a half, which a reach of
/// half an even block is but for rounding.
constexpr double dense = 0.45;
/// Of an orientation tolerance of 0 in the program.
constexpr double tightest = 1e-4 * units::pi / 180;  // [rad]
constexpr double farthest = 1.0 / 6;  // of step and reach, that the angle leaves the programmed one

std::size_t linear_place(char name) {
  return static_cast<std::size_t>(name - 'X');
}

CurvePoint point_at(const Toolpath& path, std::size_t i, double along) {
  const Segment& segment = path.segments[i];
  if (segment.kind == SegmentKind::arc) {
    return path.arc_of(segment).at(along * segment.length);
  }
  CurvePoint at;
  const Vec3& start = path.start_of(i);
  at.d1 = (segment.end - start) / segment.length;
  at.position = start + along * segment.length * at.d1;
  at.d2 = at.d3 = Vec3::Zero();
  return at;
}

/// Of a turn along a segment, at its end or its start; zero for none.
Angles slopes_of(const Toolpath& path, const KinematicChain& chain, const SegmentTurn* turn, bool at_end) {
  Angles slopes{};
  if (turn == nullptr) {
    return slopes;
  }
  const double length = path.segments[turn->segment].length;
  const std::vector<Series> angles = TurnCourse(chain, *turn, length).at(at_end ? length : 0);
  for (std::size_t k = 0; k < angles.size(); ++k) {
    slopes[rotary_place(chain.axes()[chain.rotary()[k]].name)] = angles[k].d1();
  }
  return slopes;
}

/// Shares of a segment at which the derivatives along it are looked at: even ones, and on a great circle
/// those about the place nearest to the pole, where the first axis is fastest.
std::vector<double> places_along(const TurnCourse& course, const SegmentTurn& turn, double length) {
  const int even = turn.great_circle ? 17 : 5;
  std::vector<double> places;
  for (int i = 0; i < even; ++i) {
    places.push_back(i / (even - 1.0));
  }
  if (const std::optional<double> pole = course.nearest_to_pole()) {
    for (const double away : {-0.01, -0.001, 0.0, 0.001, 0.01}) {
      places.push_back(std::clamp(*pole / length + away, 0.0, 1.0));
    }
  }
  return places;
}

/// Keeps the lower of the two.
void lower(TurnLimit& limit, double speed, TurnLimit::By by, double slope, std::size_t axis) {
  if (speed < limit.speed) {
    limit = {speed, slope, by, static_cast<std::int8_t>(axis)};
  }
}

}  // namespace

bool is_rotary_setting(std::string_view key) {
  return key == "tool_length_mm" || key == orientation_tolerance_key || key.starts_with("part_angle_");
}

double orientation_tolerance_deg(const Settings& settings) {
  return settings.has(orientation_tolerance_key) ? settings.number(orientation_tolerance_key)
                                                 : usual_orientation_tolerance_deg;
}

TurnLimiter::TurnLimiter(const Machine& machine, const KinematicChain& chain, const Settings& settings,
                         const PartOnMachine& part)
    : machine_(machine), chain_(chain), part_(part) {
  for (const std::size_t axis : chain.rotary()) {
    axes_.push_back(machine.kinematics.find(chain.axes()[axis].name));
  }
  tolerance_ = units::from_deg(orientation_tolerance_deg(settings));
  follows_program_ = follows_program_tolerance(settings);
  const std::string period = "interpolation_period_s";
  period_ = settings.has(period) ? settings.number(period) : 0;
}

void TurnLimiter::AxisCourse::add(const Series& course) {
  first = std::max(first, std::abs(course.d1()));
  second = std::max(second, std::abs(course.d2()));
  third = std::max(third, std::abs(course.d3()));
}

TurnLimiter::Courses TurnLimiter::still() const {
  Courses courses;
  for (const std::size_t k : chain_.linear()) {
    const char name = chain_.axes()[k].name;
    const AxisLimits& limit = *machine_.axes.find(name);
    courses[linear_place(name)] = {0, 0, 0, limit.velocity, limit.acceleration, limit.jerk};
  }
  for (const RotaryAxis* axis : axes_) {
    courses[linear_count + rotary_place(axis->name)] = {0,         0, 0, axis->velocity, axis->acceleration,
                                                        axis->jerk};
  }
  return courses;
}

void TurnLimiter::add_linear(const CurvePoint& at, std::span<const Series> angles, Courses& courses) const {
  const std::vector<Series> all = chain_.courses(tip_on_machine(part_, at), angles, part_.tool_length);
  for (const std::size_t k : chain_.linear()) {
    courses[linear_place(chain_.axes()[k].name)].add(all[k]);
  }
}

void TurnLimiter::set_limits(const Toolpath& path, SegmentTurn& turn) const {
  Courses courses = still();
  const double length = path.segments[turn.segment].length;
  const TurnCourse course(chain_, turn, length);
  for (const double along : places_along(course, turn, length)) {
    const std::vector<Series> angles = course.at(along * length);
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      courses[linear_count + rotary_place(axes_[k]->name)].add(angles[k]);
    }
    if (turn.at_tip && part_.known) {
      add_linear(point_at(path, turn.segment, along), angles, courses);
    }
  }
  turn.limit = {};
  for (std::size_t i = 0; i < courses.size(); ++i) {
    const AxisCourse& axis = courses[i];
    if (axis.first > 0) {
      lower(turn.limit, axis.velocity / axis.first, TurnLimit::By::velocity, axis.first, i);
    }
    if (axis.second > 0) {
      lower(turn.limit, std::sqrt(share * axis.acceleration / axis.second), TurnLimit::By::acceleration,
            axis.second, i);
    }
    if (axis.third > 0) {
      lower(turn.limit, std::cbrt(share * axis.jerk / axis.third), TurnLimit::By::jerk, axis.third, i);
    }
  }
  const double v = turn.limit.speed;
  turn.acceleration = turn.jerk = HUGE_VAL;
  for (std::size_t i = 0; i < courses.size(); ++i) {
    const AxisCourse& axis = courses[i];
    if (!(axis.first > 0)) {
      continue;
    }
    const double acceleration = (axis.acceleration - v * v * axis.second) / axis.first;
    const double jerk = (axis.jerk - v * v * v * axis.third) / axis.first;
    if (acceleration < turn.acceleration) {
      turn.acceleration = acceleration;
      turn.acceleration_axis = static_cast<std::int8_t>(i);
    }
    if (jerk < turn.jerk) {
      turn.jerk = jerk;
      turn.jerk_axis = static_cast<std::int8_t>(i);
    }
  }
  turn.tilt = tilt_at(course.angles(course.nearest_to_pole().value_or(length / 2)));
}

TurnJoint TurnLimiter::join(const Toolpath& path, std::size_t segment, const SegmentTurn* before,
                            const SegmentTurn* behind) const {
  TurnJoint joint;
  joint.segment = segment;
  joint.tilt = tilt_at(before != nullptr ? before->to : behind->from);
  const Angles from = slopes_of(path, chain_, before, true);
  const Angles to = slopes_of(path, chain_, behind, false);
  double largest = 0;
  for (std::size_t i = 0; i < joint.step.size(); ++i) {
    joint.step[i] = to[i] - from[i];
    largest = std::max(largest, std::abs(joint.step[i]));
  }
  joint.half = std::min(path.segments[segment].length, path.segments[segment + 1].length);
  if (largest > 0) {
    joint.half = std::min(joint.half, tolerance_at(path, segment) / (farthest * largest));
  }
  return joint;
}

double TurnLimiter::tolerance_at(const Toolpath& path, std::size_t segment) const {
  const auto of = [&](std::size_t i) {
    const std::optional<double>& own = path.path_control_of(i).orientation_tolerance;
    return own && follows_program_ ? std::max(*own, tightest) : tolerance_;
  };
  return std::min(of(segment), of(segment + 1));
}

void TurnLimiter::set_limit(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                            const TurnJoint* last, const TurnJoint* next, TurnJoint& joint) const {
  Meeting meeting;
  meeting.from = slopes_of(path, chain_, before, true);
  meeting.to = slopes_of(path, chain_, behind, false);
  meeting.angles = before != nullptr ? before->to : behind->from;
  meeting.at_tip = (before != nullptr && before->at_tip) || (behind != nullptr && behind->at_tip);
  meeting.begin = point_at(path, joint.segment, 1);
  meeting.end = point_at(path, joint.segment + 1, 0);
  meeting.speed_up = {speed_up(meeting.begin, before), speed_up(meeting.end, behind)};
  meeting.ramp_up = {ramp_up(meeting.begin, before), ramp_up(meeting.end, behind)};
  const double first = path.segments[joint.segment].length;
  const double second = path.segments[joint.segment + 1].length;
  meeting.held_from = {before != nullptr ? dense * first : HUGE_VAL,
                       behind != nullptr ? dense * second : HUGE_VAL};

  for (const RotaryAxis* axis : axes_) {
    const double step = joint.step[rotary_place(axis->name)];
    joint.half = reach_for_bend(meeting, step, joint.half, axis->acceleration);
  }

  /// The third derivative of axis `i` on a segment of this length, whose other end is `other`.
  const auto change = [&](const TurnJoint* other, std::size_t i, double length) {
    const double here = joint.step[i] / joint.half;
    const bool reaches = other != nullptr && std::min(joint.half, other->half) >= dense * length;
    return reaches ? (here - other->step[i] / other->half) / length : here / joint.half;
  };
  Bend bend;
  for (std::size_t i = 0; i < joint.step.size(); ++i) {
    bend.second[i] = joint.step[i] / joint.half;
    bend.before[i] = change(last, i, path.segments[joint.segment].length);
    bend.behind[i] = -change(next, i, path.segments[joint.segment + 1].length);
  }
  constexpr int halvings = 6;
  TurnJoint best = joint;
  best.limit.speed = 0;
  for (int k = 0; k < halvings; ++k) {
    const TurnLimit limit = rounded_limit(meeting, bend, joint);
    if (limit.speed > best.limit.speed) {
      best = joint;
      best.limit = limit;
    }
    if (limit.by != TurnLimit::By::velocity) {
      break;  // a shorter reach bends the course more
    }
    joint.half /= 2;
    for (std::size_t i = 0; i < joint.step.size(); ++i) {
      bend.second[i] = joint.step[i] / joint.half;
      bend.before[i] = bend.second[i] / joint.half;
      bend.behind[i] = -bend.before[i];
    }
  }
  joint = best;
  if (const TurnLimit jump = jump_limit(meeting, joint.step); jump.speed > joint.limit.speed) {
    joint.limit = jump;
    joint.half = 0;
  }
}

void TurnLimiter::hold_beside(const Toolpath& path, const TurnJoint& joint, bool at_end,
                              SegmentTurn& turn) const {
  if (joint.half < dense * path.segments[turn.segment].length) {
    return;
  }
  const Angles own = slopes_of(path, chain_, &turn, at_end);
  for (const RotaryAxis* axis : axes_) {
    const std::size_t i = rotary_place(axis->name);
    const double slope = std::abs(own[i] + (at_end ? joint.step[i] : -joint.step[i]) / 2);
    if (slope > std::abs(own[i])) {
      lower(turn.limit, axis->velocity / slope, TurnLimit::By::velocity, slope, linear_count + i);
    }
  }
}

/// How the speed of the tip may grow along a segment [mm/s2].
double TurnLimiter::speed_up(const CurvePoint& at, const SegmentTurn* turn) const {
  double acceleration = turn != nullptr ? turn->acceleration : HUGE_VAL;
  for (int j = 0; j < 3; ++j) {
    const AxisLimits* axis = machine_.axes.find("XYZ"[j]);
    if (axis != nullptr && at.d1[j] != 0) {
      acceleration = std::min(acceleration, axis->acceleration / std::abs(at.d1[j]));
    }
  }
  return acceleration;
}

/// How its acceleration may grow [mm/s3].
double TurnLimiter::ramp_up(const CurvePoint& at, const SegmentTurn* turn) const {
  double jerk = turn != nullptr ? turn->jerk : HUGE_VAL;
  for (int j = 0; j < 3; ++j) {
    const AxisLimits* axis = machine_.axes.find("XYZ"[j]);
    if (axis != nullptr && at.d1[j] != 0) {
      jerk = std::min(jerk, axis->jerk / std::abs(at.d1[j]));
    }
  }
  return jerk;
}

TurnLimit TurnLimiter::rounded_limit(const Meeting& meeting, const Bend& bend, const TurnJoint& joint) const {
  Angles middle{};
  for (std::size_t i = 0; i < middle.size(); ++i) {
    middle[i] = (meeting.from[i] + meeting.to[i]) / 2;
  }
  Courses courses = still();
  for (const RotaryAxis* axis : axes_) {
    const std::size_t i = rotary_place(axis->name);
    AxisCourse& course = courses[linear_count + i];
    course.second = std::abs(bend.second[i]);
    course.third = std::max(std::abs(bend.before[i]), std::abs(bend.behind[i]));
  }
  if (meeting.at_tip && part_.known) {
    add_linear(meeting.begin, angles_at(meeting.angles, middle, bend.second, bend.before), courses);
    add_linear(meeting.end, angles_at(meeting.angles, middle, bend.second, bend.behind), courses);
  }
  TurnLimit limit;
  for (std::size_t i = 0; i < courses.size(); ++i) {
    const AxisCourse& axis = courses[i];
    if (axis.second > 0) {
      lower(limit, std::sqrt(share * axis.acceleration / axis.second), TurnLimit::By::acceleration,
            axis.second, i);
    }
    if (axis.third > 0) {
      lower(limit, std::cbrt(share * axis.jerk / axis.third), TurnLimit::By::jerk, axis.third, i);
    }
  }
  for (const RotaryAxis* axis : axes_) {
    const std::size_t i = rotary_place(axis->name);
    const double speed = speed_for_velocity(meeting, i, joint.step[i], joint.half, axis->velocity);
    lower(limit, speed, TurnLimit::By::velocity, axis->velocity / speed, linear_count + i);
  }
  return limit;
}

/// The reach of a joint, `half` at most, within which the acceleration of a rotary axis stays within its
/// limit from the speed that the place itself allows on, while the tip speeds up on either side and the axis
/// still changes its slope: the shorter it is, the less the tip gains.
double TurnLimiter::reach_for_bend(const Meeting& meeting, double step, double half,
                                   double acceleration) const {
  constexpr int places = 4;
  constexpr int halvings = 12;
  const double slope = std::abs(step);
  if (!(slope > 0)) {
    return half;
  }
  const auto holds = [&](double reach) {
    const double speed = std::sqrt(share * acceleration * reach / slope);
    for (std::size_t side = 0; side < 2; ++side) {
      for (int k = 1; reach < meeting.held_from[side] && k < places; ++k) {
        const double part = static_cast<double>(k) / places;
        const double away = part * reach;
        const double time = std::min(away / speed, std::cbrt(6 * away / meeting.ramp_up[side]));
        const double by_jerk = speed + meeting.ramp_up[side] * time * time / 2;
        const double there = std::min(by_jerk, std::sqrt(speed * speed + 2 * meeting.speed_up[side] * away));
        if (there * there * slope / reach * (1 - part) > acceleration) {
          return false;
        }
      }
    }
    return true;
  };
  if (holds(half)) {
    return half;
  }
  double reach = half / 2;
  for (int k = 0; k < 2 * halvings && !holds(reach); ++k) {
    reach /= 2;
  }
  return halve({reach, 2 * reach}, halvings, holds).low;
}

/// The speed from which the velocity of a rotary axis stays within its limit while the tip goes on faster on
/// the side where the axis turns less, still steeper beside the joint than on the rest of the block.
double TurnLimiter::speed_for_velocity(const Meeting& meeting, std::size_t i, double step, double half,
                                       double velocity) const {
  constexpr int places = 8;
  const bool behind = std::abs(meeting.to[i]) < std::abs(meeting.from[i]);
  const double flat = behind ? meeting.to[i] : meeting.from[i];
  if (half >= meeting.held_from[behind ? 1 : 0]) {
    const double slope = std::abs(meeting.from[i] + meeting.to[i]) / 2;
    return slope > 0 ? velocity / slope : HUGE_VAL;
  }
  const double speed_up = meeting.speed_up[behind ? 1 : 0];
  double least = HUGE_VAL;  // square of the speed
  for (int k = 0; k <= places; ++k) {
    const double away = half * k / places;
    const double slope = std::abs(flat + joint_turn(step, half, behind ? away : -away).d1());
    if (slope > 0) {
      least = std::min(least, std::pow(velocity / slope, 2) - 2 * speed_up * away);
    }
  }
  return std::sqrt(std::max(least, 0.0));
}

/// The speed at which the velocities jump by jump_share of what a period takes up.
TurnLimit TurnLimiter::jump_limit(const Meeting& meeting, const Angles& step) const {
  Courses courses = still();
  for (const RotaryAxis* axis : axes_) {
    courses[linear_count + rotary_place(axis->name)].first = std::abs(step[rotary_place(axis->name)]);
  }
  if (meeting.at_tip && part_.known) {
    const auto axes_with = [&](const Angles& slopes) {
      return chain_.courses(tip_on_machine(part_, meeting.begin), angles_at(meeting.angles, slopes, {}, {}),
                            part_.tool_length);
    };
    const std::vector<Series> before = axes_with(meeting.from);
    const std::vector<Series> behind = axes_with(meeting.to);
    for (const std::size_t k : chain_.linear()) {
      courses[linear_place(chain_.axes()[k].name)].first = std::abs(behind[k].d1() - before[k].d1());
    }
  }
  TurnLimit jump;
  for (std::size_t i = 0; i < courses.size(); ++i) {
    const AxisCourse& axis = courses[i];
    if (axis.first > 0) {
      lower(jump, jump_share * axis.acceleration * period_ / axis.first, TurnLimit::By::jump, axis.first, i);
    }
  }
  return jump;
}

/// The rotary axes in the order of the chain, with these derivatives.
std::vector<Series> TurnLimiter::angles_at(const Angles& angles, const Angles& slopes, const Angles& second,
                                           const Angles& third) const {
  std::vector<Series> series;
  for (const RotaryAxis* axis : axes_) {
    const std::size_t i = rotary_place(axis->name);
    series.emplace_back(angles[i], slopes[i], second[i], third[i]);
  }
  return series;
}

/// Of the tool to the first of two rotary axes [rad]; -1 where there is only one.
double TurnLimiter::tilt_at(const Angles& angles) const {
  if (axes_.size() != 2) {
    return -1;
  }
  const double along =
      std::abs(tool_direction(chain_, angles).dot(chain_.axes()[chain_.rotary()[0]].direction));
  return std::acos(std::min(1.0, along));
}

Series joint_turn(double step, double half, double away) {
  if (!(half > 0) || std::abs(away) >= half) {
    return {};
  }
  const double t = 1 - std::abs(away) / half;  // of the way from the nearer end
  const double side = std::signbit(away) ? step : -step;
  return {step * half * t * t * t / 6, side * t * t / 2, step * t / half, side / (half * half)};
}

}  // namespace feedscope
