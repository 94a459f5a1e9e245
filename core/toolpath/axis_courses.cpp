#include "core/toolpath/axis_courses.h"

#include <algorithm>
#include <cmath>

#include "core/toolpath/turn_course.h"

namespace feedscope {
namespace {

/// Share of the jerk left by turning that goes to 3 q2 v v' and to the growth of q3 v^3 on a ramp; the rest
/// is for q1 v''.
constexpr double across = 0.5;

double faster(double speed, double acceleration, double reach) {
  return std::sqrt(speed * speed + 2 * acceleration * reach);
}

TurnLimit limit(double speed, TurnLimit::By by, double slope, std::size_t axis) {
  return {speed, slope, by, static_cast<std::int8_t>(axis)};
}

}  // namespace

AxisCourses::AxisCourses(const Machine& machine, const Shares& shares) : shares_(shares) {
  for (std::size_t i = 0; i < coordinate_names.size(); ++i) {
    if (const AxisLimits* axis = machine.axes.find(coordinate_names[i])) {
      axes_[i] = {0, 0, 0, axis->velocity, axis->acceleration, axis->jerk};
    }
  }
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    axes_[coordinate_names.size() + rotary_place(axis.name)] = {
        0, 0, 0, axis.velocity, axis.acceleration, axis.jerk};
  }
  if (std::isinf(shares.jerk)) {
    for (Course& axis : axes_) {
      axis.jerk = shares.jerk;
    }
  }
}

void AxisCourses::add(std::size_t axis, const Series& course) {
  Course& of = axes_[axis];
  of.first = std::max(of.first, std::abs(course.d1()));
  of.second = std::max(of.second, std::abs(course.d2()));
  of.third = std::max(of.third, std::abs(course.d3()));
}

void AxisCourses::add(const AxisCourses& other) {
  for (std::size_t i = 0; i < count; ++i) {
    axes_[i].first = std::max(axes_[i].first, other.axes_[i].first);
    axes_[i].second = std::max(axes_[i].second, other.axes_[i].second);
    axes_[i].third = std::max(axes_[i].third, other.axes_[i].third);
  }
}

void AxisCourses::reach_between(double step) {
  for (Course& axis : axes_) {
    axis.first += step * step / 8 * axis.third;
  }
}

TurnLimit AxisCourses::speed() const {
  TurnLimit least = speed_of_bend();
  lower(least, speed_of_velocity());
  return least;
}

TurnLimit AxisCourses::speed_of_velocity() const {
  TurnLimit least;
  for (std::size_t i = 0; i < count; ++i) {
    if (axes_[i].first > 0) {
      lower(least, limit(axes_[i].velocity / axes_[i].first, TurnLimit::By::velocity, axes_[i].first, i));
    }
  }
  return least;
}

TurnLimit AxisCourses::speed_of_bend() const {
  TurnLimit least;
  for (std::size_t i = 0; i < count; ++i) {
    const Course& axis = axes_[i];
    if (axis.second > 0) {
      lower(least, limit(std::sqrt(shares_.acceleration * axis.acceleration / axis.second),
                         TurnLimit::By::acceleration, axis.second, i));
    }
    if (axis.third > 0 && axis.limits_jerk()) {
      lower(least,
            limit(std::cbrt(turning_jerk * axis.jerk / axis.third), TurnLimit::By::jerk, axis.third, i));
    }
  }
  return least;
}

bool AxisCourses::Course::limits_jerk() const {
  return jerk < HUGE_VAL;
}

double AxisCourses::Course::jerk_in_bend(double speed, double along) const {
  return third * speed * speed * speed + 3 * second * speed * along;
}

/// Newton's method for the root of a convex function of the acceleration along the path, from above.
double AxisCourses::Course::acceleration_in_bend(double speed, double reach) const {
  constexpr int steps = 8;
  const double at_constant_speed = jerk_in_bend(speed, 0);
  const double most =
      at_constant_speed + across * std::max(jerk - at_constant_speed, (1 - turning_jerk) * jerk);
  double a = (most - at_constant_speed) / (3 * second * speed);
  if (!(reach > 0)) {
    return a;
  }
  a = std::min({a, std::cbrt(std::pow(most / (3 * second), 2) / (2 * reach)),
                (std::pow(most / third, 2.0 / 3) - speed * speed) / (2 * reach)});
  for (int i = 0; i < steps; ++i) {
    const double v = faster(speed, a, reach);
    const double slope = 3 * third * v * reach + 3 * second * (v + a * reach / v);
    a -= (jerk_in_bend(v, a) - most) / slope;
  }
  return a;
}

TurnRamp AxisCourses::ramp(double speed, double reach) const {
  TurnRamp least;
  for (std::size_t i = 0; i < count; ++i) {
    const Course& axis = axes_[i];
    double acceleration = HUGE_VAL;
    bool by_jerk = false;
    if (axis.first > 0) {
      const double left = std::max(axis.acceleration - speed * speed * axis.second,
                                   (1 - shares_.acceleration) * axis.acceleration);
      acceleration = left / (axis.first + 2 * reach * axis.second);
    }
    if ((axis.second > 0 || axis.third > 0) && axis.limits_jerk()) {
      const double in_bend = axis.acceleration_in_bend(speed, reach);
      by_jerk = in_bend < acceleration;
      acceleration = std::min(acceleration, in_bend);
    }
    lower(least, {.acceleration = acceleration,
                  .acceleration_axis = static_cast<std::int8_t>(i),
                  .acceleration_by_jerk = by_jerk,
                  .acceleration_slope = by_jerk ? axis.second : axis.first});
  }
  const double along = least.acceleration < HUGE_VAL ? least.acceleration : 0;
  const double fastest = faster(speed, along, reach);
  for (std::size_t i = 0; i < count; ++i) {
    const Course& axis = axes_[i];
    if (axis.first > 0 && axis.limits_jerk()) {
      const double left = std::max(axis.jerk - axis.jerk_in_bend(fastest, along),
                                   (1 - across) * (1 - turning_jerk) * axis.jerk);
      lower(least,
            {.jerk = left / axis.first, .jerk_axis = static_cast<std::int8_t>(i), .jerk_slope = axis.first});
    }
  }
  return least;
}

void lower(TurnLimit& limit, const TurnLimit& other) {
  if (other.speed < limit.speed) {
    limit = other;
  }
}

void lower(TurnRamp& ramp, const TurnRamp& other) {
  if (other.acceleration < ramp.acceleration) {
    ramp.acceleration = other.acceleration;
    ramp.acceleration_axis = other.acceleration_axis;
    ramp.acceleration_by_jerk = other.acceleration_by_jerk;
    ramp.acceleration_slope = other.acceleration_slope;
  }
  if (other.jerk < ramp.jerk) {
    ramp.jerk = other.jerk;
    ramp.jerk_axis = other.jerk_axis;
    ramp.jerk_slope = other.jerk_slope;
  }
}

}  // namespace feedscope
