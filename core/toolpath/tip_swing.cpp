#include "core/toolpath/tip_swing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/units.h"
#include "core/machine/rotary_axis.h"
#include "core/toolpath/axis_courses.h"
#include "core/toolpath/turn_course.h"

namespace feedscope {
namespace {

constexpr std::size_t first_rotary = coordinate_names.size();

/// Shares of a turn at which its derivatives are evaluated: X, Y and Z go up and down with the angles.
std::vector<double> shares_of(const TurnCourse& course, const RotaryTurn& turn, double way) {
  constexpr double most_between = units::from_deg(2.5);
  double turned = 0;
  for (std::size_t i = 0; i < turn.to.size(); ++i) {
    turned += std::abs(turn.to[i] - turn.from[i]);
  }
  const int even = std::max(64, static_cast<int>(std::ceil(turned / most_between)));
  std::vector<double> shares;
  for (int i = 0; i <= even; ++i) {
    shares.push_back(i / static_cast<double>(even));
  }
  if (const std::optional<double> pole = course.nearest_to_pole()) {
    for (const double away : {-0.01, -0.001, 0.0, 0.001, 0.01}) {
      shares.push_back(std::clamp(*pole / way + away, 0.0, 1.0));
    }
  }
  return shares;
}

/// Angle by which the tool's direction turns or, without a great circle, the axes themselves do [rad].
double way_of(const KinematicChain& chain, const RotaryTurn& turn) {
  if (turn.great_circle) {
    const Vec3 from = tool_direction(chain, turn.from);
    const Vec3 to = tool_direction(chain, turn.to);
    const double swing = std::atan2(from.cross(to).norm(), from.dot(to));
    if (swing > 0) {
      return swing;
    }
  }
  double way = 0;
  for (std::size_t i = 0; i < turn.to.size(); ++i) {
    way = std::hypot(way, turn.to[i] - turn.from[i]);
  }
  return way;
}

SegmentTurn segment_turn_of(const RotaryTurn& turn) {
  SegmentTurn whole;
  whole.from = turn.from;
  whole.to = turn.to;
  whole.great_circle = turn.great_circle;
  return whole;
}

/// Axis that limits a law for most of its time, an index into cause_axes.
std::int8_t holding_axis(const RotaryTurn::Law& law, const TurnLimit& fastest, const TurnRamp& ramp) {
  constexpr double reached = 1 - 1e-9;
  const RestToRestPlace most = rest_to_rest_peaks(law.way, law.velocity, law.acceleration, law.jerk);
  if (most.velocity >= reached * fastest.speed) {
    return fastest.axis;
  }
  return most.acceleration >= reached * law.acceleration ? ramp.acceleration_axis : ramp.jerk_axis;
}

}  // namespace

void TipSwing::set_law(const Vec3& tip, double feed, double time, RotaryTurn& turn) const {
  constexpr double slower = 0.92;
  constexpr int trials = 48;
  if (turn.great_circle) {
    const double swing = way_of(chain_, turn);
    turn.great_circle = TurnCourse(chain_, segment_turn_of(turn), swing).goes_on();
  }
  const double way = way_of(chain_, turn);
  const TurnCourse course(chain_, segment_turn_of(turn), way);
  CurvePoint place;
  place.position = tip;
  place.d1 = place.d2 = place.d3 = Vec3::Zero();
  const std::array<Series, 3> held = tip_on_machine(part_, place);
  AxisCourses courses(machine_);
  for (const double share : shares_of(course, turn, way)) {
    const std::vector<Series> angles = course.at(share * way);
    const std::vector<Series> all = chain_.courses(held, angles, part_.tool_length);
    for (std::size_t k = 0; k < angles.size(); ++k) {
      courses.add(first_rotary + rotary_place(chain_.axes()[chain_.rotary()[k]].name), angles[k]);
    }
    for (const std::size_t k : chain_.linear()) {
      courses.add(static_cast<std::size_t>(chain_.axes()[k].name - 'X'), all[k]);
    }
  }
  const TurnLimit fastest = courses.speed();
  const double asked = time > 0 ? way / time : feed;
  double velocity = asked > 0 ? std::min(asked, fastest.speed) : fastest.speed;
  turn.time = HUGE_VAL;
  for (int i = 0; i < trials; ++i, velocity *= slower) {  // a slower turn leaves more for its ramps
    const TurnRamp ramp = courses.ramp(velocity, 0);
    const RotaryTurn::Law law{way, velocity, ramp.acceleration, ramp.jerk};
    const double takes = rest_to_rest_time(way, velocity, ramp.acceleration, ramp.jerk);
    if (takes < turn.time) {
      turn.time = takes;
      turn.law = law;
      turn.axis = holding_axis(law, fastest, ramp);
    }
  }
}

}  // namespace feedscope
