#include "core/toolpath/turn_limiter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/roots.h"
#include "core/base/units.h"
#include "core/machine/contour_tolerance.h"
#include "core/toolpath/joint_shape.h"
#include "core/toolpath/joint_stop.h"
#include "core/toolpath/turn_course.h"

namespace feedscope {
namespace {

using Angles = std::array<double, 3>;

constexpr std::size_t linear_count = coordinate_names.size();
constexpr AxisCourses::Shares of_bound{1, HUGE_VAL};
/// Used for an orientation tolerance of 0 in the program.
constexpr double tightest = 1e-4 * units::pi / 180;  // [rad]

std::size_t linear_place(char name) {
  return static_cast<std::size_t>(name - 'X');
}

/// Slopes of a turn along a segment, at its end or its start; zero for none.
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

/// Shares of a segment at which the derivatives along it are evaluated: even ones, and on a great circle also
/// those around the place nearest to the pole, where the first axis is fastest.
std::vector<double> places_along(const TurnCourse& course, const SegmentTurn& turn, double length) {
  constexpr double most_between = units::from_deg(7.5);
  double turned = 0;
  for (std::size_t k = 0; k < turn.to.size(); ++k) {
    turned += std::abs(turn.to[k] - turn.from[k]);
  }
  const int even =
      std::max(turn.great_circle ? 17 : 5, 1 + static_cast<int>(std::ceil(turned / most_between)));
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

/// Highest speed that counts for ramps on a segment: `speed`, or its feed.
double ramp_speed(const Toolpath& path, std::size_t segment, double speed) {
  const Segment& of = path.segments[segment];
  return of.feed > 0 && !of.rapid ? std::min(speed, of.feed) : speed;
}

void scale_reach(TurnJoint& joint, double by) {
  joint.before *= by;
  joint.behind *= by;
}

/// Reach of a joint: side 0 is before its place, 1 after it.
double reach_of(const TurnJoint& joint, std::size_t side) {
  return side == 0 ? joint.before : joint.behind;
}

/// Distance `away` from the place, with the sign of the side.
double to_side(std::size_t side, double away) {
  return side == 0 ? -away : away;
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
  contour_tolerance_ = settings.has(contour_tolerance_key) ? settings.number(contour_tolerance_key) : 0;
  const std::string jerk = "jerk";
  is_bound_ = settings.has(jerk) && settings.text(jerk) == "off";
}

void TurnLimiter::add_linear(const CurvePoint& at, std::span<const Series> angles,
                             AxisCourses& courses) const {
  const std::vector<Series> all = chain_.courses(tip_on_machine(part_, at), angles, part_.tool_length);
  for (const std::size_t k : chain_.linear()) {
    courses.add(linear_place(chain_.axes()[k].name), all[k]);
  }
}

/// Adds the derivatives of all axes along a turn.
void TurnLimiter::add_turn(const Toolpath& path, const SegmentTurn& turn, AxisCourses& courses) const {
  const double length = path.segments[turn.segment].length;
  const TurnCourse course(chain_, turn, length);
  for (const double along : places_along(course, turn, length)) {
    const std::vector<Series> angles = course.at(along * length);
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      courses.add(linear_count + rotary_place(axes_[k]->name), angles[k]);
    }
    if (turn.at_tip && part_.known) {
      add_linear(path.place_on(turn.segment, along * length), angles, courses);
    }
  }
}

void TurnLimiter::set_limits(const Toolpath& path, SegmentTurn& turn) const {
  AxisCourses courses(machine_);
  add_turn(path, turn, courses);
  turn.limit = courses.speed();
  turn.ramp = courses.ramp(ramp_speed(path, turn.segment, turn.limit.speed), 0);
  const double length = path.segments[turn.segment].length;
  const TurnCourse course(chain_, turn, length);
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
  const double first = path.segments[segment].length;
  const double second = path.segments[segment + 1].length;
  joint.before = std::min(first, largest_reach_ratio * second);
  joint.behind = std::min(second, largest_reach_ratio * first);
  if (largest > 0) {
    const double lean = largest * joint_shape(joint.before, joint.behind, 0).value();
    scale_reach(joint, std::min(1.0, tolerance_at(path, segment) / lean));
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

TurnLimiter::Meeting TurnLimiter::meeting_of(const Toolpath& path, const SegmentTurn* before,
                                             const SegmentTurn* behind, const TurnJoint& joint) const {
  Meeting meeting;
  for (std::size_t i = 0; i < meeting.sides.size(); ++i) {
    Side& side = meeting.sides[i];
    const bool comes = i == 0;
    side.segment = joint.segment + i;
    side.length = path.segments[side.segment].length;
    side.turn = comes ? before : behind;
    side.slopes = slopes_of(path, chain_, side.turn, comes);
    const CurvePoint place = path.place_on(side.segment, comes ? side.length : 0);
    side.speed_up = speed_up(place, side.turn);
    side.ramp_up = ramp_up(place, side.turn);
    side.held_from = least_shaping_reach(side.length);
    meeting.at_tip = meeting.at_tip || (side.turn != nullptr && side.turn->at_tip);
  }
  meeting.angles = before != nullptr ? before->to : behind->from;
  return meeting;
}

void TurnLimiter::choose_reach(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                               const Neighbours& beside, TurnJoint& joint) const {
  constexpr int halvings = 6;
  const Meeting meeting = meeting_of(path, before, behind, joint);
  for (const RotaryAxis* axis : axes_) {
    scale_reach(joint, share_for_bend(meeting, joint, rotary_place(axis->name), axis->acceleration));
  }
  TurnJoint best = joint;
  best.limit.speed = 0;
  for (int k = 0; k < halvings; ++k) {
    joint.limit = rounded_limit(meeting, bend_of(path, meeting, beside, joint), joint);
    if (joint.limit.speed > best.limit.speed) {
      best = joint;
    }
    if (joint.limit.by != TurnLimit::By::velocity) {
      break;  // a shorter reach bends the course more
    }
    scale_reach(joint, 0.5);
  }
  joint = best;
  if (const TurnLimit jump = jump_limit(path, meeting, joint); jump.speed > joint.limit.speed) {
    joint.limit = jump;
    joint.before = joint.behind = 0;
  }
}

void TurnLimiter::set_limit(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                            const Neighbours& beside, TurnJoint& joint) const {
  const Meeting meeting = meeting_of(path, before, behind, joint);
  joint.ramp = {};
  if (!(joint.before > 0)) {
    joint.limit = jump_limit(path, meeting, joint);
    return;
  }
  const AxisCourses bend = bend_of(path, meeting, beside, joint);
  joint.limit = rounded_limit(meeting, bend, joint);
  double speed = joint.limit.speed;
  for (const Side& side : meeting.sides) {
    speed = ramp_speed(path, side.segment,
                       std::min(speed, side.turn != nullptr ? side.turn->limit.speed : HUGE_VAL));
  }
  // In the middle of a segment shaped by two joints the tip has covered half of it.
  joint.ramp = bend.ramp(speed, std::max(joint.before, joint.behind) / 2);
}

bool TurnLimiter::stops(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                        const TurnJoint& joint) const {
  std::array<StopSide, 2> sides;
  const Meeting meeting = meeting_of(path, before, behind, joint);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = meeting.sides[i];
    const double reach = reach_of(joint, i);
    const bool shaped = shapes_segment(reach, side.length);
    const double top =
        ramp_speed(path, side.segment, side.turn != nullptr ? side.turn->limit.speed : HUGE_VAL);
    sides[i] = {shaped ? reach : side.length / 2, top, side.speed_up, side.ramp_up, shaped};
  }
  const double blend = least_blend(path, joint.segment, contour_tolerance_, follows_program_);
  return stop_is_faster(joint, sides, blend);
}

void TurnLimiter::set_bound(const Toolpath& path, SegmentTurn& turn) const {
  AxisCourses courses(machine_, of_bound);
  add_turn(path, turn, courses);
  turn.limit = courses.speed();
  turn.ramp = courses.ramp(0, 0);
}

void TurnLimiter::set_bound(const Toolpath& path, const SegmentTurn* before, const SegmentTurn* behind,
                            TurnJoint& joint) const {
  const Meeting meeting = meeting_of(path, before, behind, joint);
  joint.ramp = {};
  if (!(joint.before > 0)) {
    joint.limit = jump_limit(path, meeting, joint);
    return;
  }
  AxisCourses courses(machine_, of_bound);
  const Side& side = meeting.sides[0];
  std::vector<Series> angles = angles_at(meeting.angles, side.slopes);
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    const std::size_t axis = rotary_place(axes_[k]->name);
    angles[k] += joint_turn(joint, axis, -0.0);
    courses.add(linear_count + axis, angles[k]);
  }
  if (meeting.at_tip && part_.known) {
    add_linear(path.place_on(joint.segment, path.segments[joint.segment].length), angles, courses);
  }
  joint.limit = courses.speed();
}

/// Acceleration of the tip along a segment that X, Y and Z and the turn allow [mm/s2].
double TurnLimiter::speed_up(const CurvePoint& at, const SegmentTurn* turn) const {
  double acceleration = turn != nullptr ? turn->ramp.acceleration : HUGE_VAL;
  for (int j = 0; j < 3; ++j) {
    const AxisLimits* axis = machine_.axes.find("XYZ"[j]);
    if (axis != nullptr && at.d1[j] != 0) {
      acceleration = std::min(acceleration, axis->acceleration / std::abs(at.d1[j]));
    }
  }
  return acceleration;
}

/// Jerk of the tip that they allow [mm/s3].
double TurnLimiter::ramp_up(const CurvePoint& at, const SegmentTurn* turn) const {
  double jerk = turn != nullptr ? turn->ramp.jerk : HUGE_VAL;
  for (int j = 0; j < 3; ++j) {
    const AxisLimits* axis = machine_.axes.find("XYZ"[j]);
    if (axis != nullptr && at.d1[j] != 0) {
      jerk = std::min(jerk, axis->jerk / std::abs(at.d1[j]));
    }
  }
  return jerk;
}

/// Derivatives of all axes within the reach of a joint. Third ones are largest at its place, at an end of the
/// reach or at the place of the neighbouring joint; second ones also at its place or, with unequal reaches,
/// near the middle of the shorter one.
AxisCourses TurnLimiter::bend_of(const Toolpath& path, const Meeting& meeting, const Neighbours& beside,
                                 const TurnJoint& joint) const {
  constexpr double within = 1 - 1e-6;
  AxisCourses courses(machine_);
  for (std::size_t i = 0; i < meeting.sides.size(); ++i) {
    const Side& side = meeting.sides[i];
    const TurnJoint* other = i == 0 ? beside.last : beside.next;
    const auto look = [&](double away) {
      const double s = i == 0 ? side.length - away : away;
      std::vector<Series> angles = side.turn != nullptr ? TurnCourse(chain_, *side.turn, side.length).at(s)
                                                        : angles_at(meeting.angles, {});
      for (std::size_t k = 0; k < axes_.size(); ++k) {
        const std::size_t axis = rotary_place(axes_[k]->name);
        angles[k] += joint_turn(joint, axis, to_side(i, away));
        if (other != nullptr) {
          angles[k] += joint_turn(*other, axis, to_side(1 - i, side.length - away));
        }
        courses.add(linear_count + axis, angles[k]);
      }
      if (meeting.at_tip && part_.known) {
        add_linear(path.place_on(side.segment, s), angles, courses);
      }
    };
    const double reach = reach_of(joint, i);
    look(0);
    look(reach / 2);
    const bool goes_on = other != nullptr && reach_of(*other, 1 - i) > 0;
    if (!goes_on || reach < within * side.length) {
      look(within * reach);
    }
  }
  return courses;
}

TurnLimit TurnLimiter::rounded_limit(const Meeting& meeting, const AxisCourses& bend,
                                     const TurnJoint& joint) const {
  TurnLimit limit = bend.speed_of_bend();
  for (const RotaryAxis* axis : axes_) {
    const std::size_t i = rotary_place(axis->name);
    const double speed = speed_for_velocity(meeting, joint, i, axis->velocity);
    lower(limit, {speed, axis->velocity / speed, TurnLimit::By::velocity,
                  static_cast<std::int8_t>(linear_count + i)});
  }
  return limit;
}

/// Share of a joint's reach with which a rotary axis stays within its acceleration: the tip starts at the
/// speed that the place itself allows and speeds up on either side while the axis still changes its slope.
/// The shorter the reach, the less speed the tip gains.
double TurnLimiter::share_for_bend(const Meeting& meeting, const TurnJoint& joint, std::size_t i,
                                   double acceleration) const {
  constexpr int places = 4;
  constexpr int halvings = 12;
  if (joint.step[i] == 0) {
    return 1;
  }
  const auto holds = [&](double by) {
    TurnJoint shorter = joint;
    scale_reach(shorter, by);
    const auto second = [&](double away) { return std::abs(joint_turn(shorter, i, away).d2()); };
    const double square = AxisCourses::turning_acceleration * acceleration / second(0);
    const double speed = std::sqrt(square);
    for (std::size_t k = 0; k < meeting.sides.size(); ++k) {
      const Side& side = meeting.sides[k];
      const double reach = reach_of(shorter, k);
      for (int place = 1; reach < side.held_from && place < places; ++place) {
        const double away = reach * place / places;
        const double time = std::min(away / speed, std::cbrt(6 * away / side.ramp_up));
        const double by_jerk = speed + side.ramp_up * time * time / 2;
        const double there = std::min(by_jerk, std::sqrt(square + 2 * side.speed_up * away));
        if (there * there * second(to_side(k, away)) > acceleration) {
          return false;
        }
      }
    }
    return true;
  };
  if (holds(1)) {
    return 1;
  }
  double share = 0.5;
  for (int k = 0; k < 2 * halvings && !holds(share); ++k) {
    share /= 2;
  }
  return halve({share, 2 * share}, halvings, holds).low;
}

/// Largest speed at the joint with which a rotary axis stays within its velocity. The tip speeds up on the
/// side where the axis turns less, and near the joint the axis is still steeper than on the rest of the
/// block.
double TurnLimiter::speed_for_velocity(const Meeting& meeting, const TurnJoint& joint, std::size_t i,
                                       double velocity) const {
  constexpr int places = 8;
  const std::size_t k = std::abs(meeting.sides[1].slopes[i]) < std::abs(meeting.sides[0].slopes[i]) ? 1 : 0;
  const Side& flat = meeting.sides[k];
  const double reach = reach_of(joint, k);
  const auto slope_at = [&](double away) {
    return std::abs(flat.slopes[i] + joint_turn(joint, i, to_side(k, away)).d1());
  };
  if (flat.turn != nullptr && reach >= flat.held_from) {  // TurnCeiling limits it there
    return slope_at(0) > 0 ? velocity / slope_at(0) : HUGE_VAL;
  }
  double least = HUGE_VAL;  // square of the speed
  for (int place = 0; place <= places; ++place) {
    const double away = reach * place / places;
    if (const double slope = slope_at(away); slope > 0) {
      least = std::min(least, std::pow(velocity / slope, 2) - 2 * flat.speed_up * away);
    }
  }
  return std::sqrt(std::max(least, 0.0));
}

/// Speed at which the velocities jump by jump_share of what an axis makes up within a period.
TurnLimit TurnLimiter::jump_limit(const Toolpath& path, const Meeting& meeting,
                                  const TurnJoint& joint) const {
  TurnLimit jump;
  const auto hold = [&](std::size_t axis, double acceleration, double step) {
    if (step > 0) {
      lower(jump, {jump_share * acceleration * period_ / step, step, TurnLimit::By::jump,
                   static_cast<std::int8_t>(axis)});
    }
  };
  for (const RotaryAxis* axis : axes_) {
    const std::size_t i = rotary_place(axis->name);
    hold(linear_count + i, axis->acceleration, std::abs(joint.step[i]));
  }
  if (meeting.at_tip && part_.known) {
    const std::array<Series, 3> tip =
        tip_on_machine(part_, path.place_on(joint.segment, path.segments[joint.segment].length));
    const auto axes_on = [&](const Side& side) {
      return chain_.courses(tip, angles_at(meeting.angles, side.slopes), part_.tool_length);
    };
    const std::vector<Series> before = axes_on(meeting.sides[0]);
    const std::vector<Series> behind = axes_on(meeting.sides[1]);
    for (const std::size_t k : chain_.linear()) {
      const char name = chain_.axes()[k].name;
      hold(linear_place(name), machine_.axes.find(name)->acceleration,
           std::abs(behind[k].d1() - before[k].d1()));
    }
  }
  return jump;
}

/// Rotary axes in the order of the chain, with these slopes.
std::vector<Series> TurnLimiter::angles_at(const Angles& angles, const Angles& slopes) const {
  std::vector<Series> series;
  for (const RotaryAxis* axis : axes_) {
    const std::size_t i = rotary_place(axis->name);
    series.emplace_back(angles[i], slopes[i], 0, 0);
  }
  return series;
}

/// Angle of the tool to the first of two rotary axes [rad]; -1 where there is only one.
double TurnLimiter::tilt_at(const Angles& angles) const {
  if (axes_.size() != 2) {
    return -1;
  }
  const double along =
      std::abs(tool_direction(chain_, angles).dot(chain_.axes()[chain_.rotary()[0]].direction));
  return std::acos(std::min(1.0, along));
}

}  // namespace feedscope
