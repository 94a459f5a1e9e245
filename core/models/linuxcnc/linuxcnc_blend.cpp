#include "core/models/linuxcnc/linuxcnc_blend.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/limits/axis_share.h"

namespace feedscope {
namespace {

using std::numbers::pi;

/// Least limit of the axes in the plane across unit vector `n`, and its axis.
AxisBound plane_limit(const Vec3& axes, const Vec3& n) {
  constexpr double least_part = 1e-12;
  AxisBound limit{std::numeric_limits<double>::infinity(), -1};
  for (std::int8_t i = 0; i < 3; ++i) {
    const double part = std::sqrt(std::max(1 - n[i] * n[i], 0.0));
    const double value = axes[i] / std::max(part, least_part);
    if (axes[i] > 0 && value < limit.value) {  // 0: not on this machine
      limit = {value, i};
    }
  }
  return limit;
}

/// Geometry that one of the two segments contributes to the blend.
struct Side {
  bool is_arc = false;
  bool convex = false;
  Vec3 tangent;             ///< in the geometry of the blend, in the direction of motion
  Vec3 center;              ///< of an arc, moved where it is a spiral [mm]
  double radius = 0;        ///< [mm]
  double largest_turn = 0;  ///< largest part of an arc for the blend [rad]
  double available = 0;     ///< length available for the blend [mm]
};

double half_angle(const Vec3& in, const Vec3& out) {
  return std::acos(std::clamp(-in.dot(out), -1.0, 1.0)) / 2;
}

/// `other`: direction of the other segment, away from the joint.
Side side_of_arc(const LinuxCncSegment& segment, bool is_first, const Vec3& other, double theta) {
  constexpr double share_of_first = 2.0 / 3;
  constexpr double share_of_second = 1.0 / 3;
  const LinuxCncCourse& course = segment.course;
  Side side;
  side.is_arc = true;
  const double s = is_first ? course.length : 0;
  const Vec3 joint = course.at(s);
  const double turned = is_first ? course.angle : 0;
  const Vec3 across = course.normal.cross(course.spoke);
  const Vec3 out = std::cos(turned) * course.spoke + std::sin(turned) * across;
  const double slope = course.spiral / course.angle;
  const Vec3 axis_place = course.center + (is_first ? course.height : 0) * course.normal;
  side.center = axis_place + slope * course.normal.cross(out);
  side.radius = (joint - side.center).norm();
  side.convex = other.dot(side.center - joint) > 0;
  const double share = is_first ? share_of_first : share_of_second;
  side.largest_turn = std::min(course.angle * share, side.convex ? theta : pi / 2);
  side.tangent = course.tangent(s);
  if (side.convex) {
    const double way = course.length * (side.largest_turn / 2) / course.angle;
    const Vec3 place = course.at(is_first ? course.length - way : way);
    side.tangent = (is_first ? Vec3(joint - place) : Vec3(place - joint)).normalized();
    side.available = std::sin(side.largest_turn / 4) * side.radius;
  } else {
    side.available = side.largest_turn * side.radius;
  }
  return side;
}

/// Centre of the blend circle of `radius` that touches both sides, nearest to the joint.
std::optional<Vec3> blend_center(const Side& first, const Side& second, const Vec3& joint, const Vec3& inside,
                                 double radius) {
  const auto distance = [&](const Side& side) {
    return side.convex ? side.radius - radius : side.radius + radius;
  };
  if (first.is_arc && second.is_arc) {
    const Vec3 way = second.center - first.center;
    const double d = way.norm();
    const double r1 = distance(first);
    const double r2 = distance(second);
    if (!(d > 0) || r1 < 0 || r2 < 0) {
      return std::nullopt;
    }
    const double along = (d * d + r1 * r1 - r2 * r2) / (2 * d);
    const double square = r1 * r1 - along * along;
    if (square < 0) {
      return std::nullopt;
    }
    const Vec3 u = way / d;
    const Vec3 base = first.center + along * u;
    Vec3 across = joint - base;
    across -= across.dot(u) * u;
    if (!(across.norm() > 0)) {
      return std::nullopt;
    }
    return base + std::sqrt(square) * across.normalized();
  }
  const Side& line = first.is_arc ? second : first;
  const Side& arc = first.is_arc ? first : second;
  const Vec3 u = first.is_arc ? line.tangent : Vec3(-line.tangent);  // away from the joint
  const Vec3 normal = (inside - inside.dot(u) * u).normalized();
  const Vec3 w = joint + radius * normal - arc.center;
  const double half = w.dot(u);
  const double reach = distance(arc);
  const double square = half * half - w.squaredNorm() + reach * reach;
  if (square < 0) {
    return std::nullopt;
  }
  const double near = -half + (half > 0 ? 1 : -1) * std::sqrt(square);
  return joint + near * u + radius * normal;
}

/// Point where a blend circle touches a side.
Vec3 touching_point(const Side& side, const Vec3& joint, const Vec3& center) {
  if (side.is_arc) {
    return side.center + side.radius * (center - side.center).normalized();
  }
  return joint + (center - joint).dot(side.tangent) * side.tangent;
}

/// Turn from the joint along the arc to `place` [rad].
double turn_to(const Side& side, const Vec3& joint, const Vec3& place) {
  const Vec3 a = (joint - side.center).normalized();
  const Vec3 b = (place - side.center).normalized();
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

struct Speeds {
  double requested = 0;
  double goal = 0;
};

Speeds speeds_of(const LinuxCncSegment& p, const LinuxCncSegment& t, const LinuxCncSettings& settings,
                 double phi, double plane_speed, bool both_lines) {
  constexpr double largest_turn = 0.49 * pi;
  Speeds speeds;
  speeds.requested = std::max(std::min(p.requested, p.largest), std::min(t.requested, t.largest));
  speeds.goal = std::max(std::min(p.requested * settings.max_override, p.largest),
                         std::min(t.requested * settings.max_override, t.largest));
  double altitude = 0;
  if (both_lines) {
    const double turn = std::min(phi, largest_turn);
    const double m1 = std::min(p.largest, t.largest / std::cos(turn));
    const double m2 = std::min(t.largest, p.largest / std::cos(turn));
    const double base = (m2 * t.course.tangent(0) - m1 * p.course.tangent(p.course.length)).norm();
    altitude = base > 0 ? m1 * m2 * std::sin(phi) / base : 0;
  }
  speeds.goal = std::min(speeds.goal, std::max(altitude, plane_speed));
  return speeds;
}

}  // namespace

std::optional<LinuxCncBlend> find_linuxcnc_blend(const LinuxCncSegment& p, const LinuxCncSegment& t,
                                                 const LinuxCncSettings& settings) {
  constexpr double same_angle = 1e-6;
  constexpr double least_of_arcs = pi / 12;  // 15 degrees
  constexpr double flat = 1e-3;              // height of a helix [mm]
  constexpr double gap_cycles = 4;
  if ((p.course.is_arc && std::abs(p.course.height) > flat) ||
      (t.course.is_arc && std::abs(t.course.height) > flat)) {
    return std::nullopt;
  }
  const Vec3 joint = t.course.at(0);
  const Vec3 e = p.course.tangent(p.course.length);
  const Vec3 b = t.course.tangent(0);
  const double theta0 = half_angle(e, b);
  if (theta0 < same_angle || pi / 2 - theta0 < same_angle) {
    return std::nullopt;
  }
  Side first;
  Side second;
  first.tangent = e;
  second.tangent = b;
  first.available = std::min(p.length, p.nominal_length / 2);
  second.available = t.length / 2;
  double theta = theta0;
  if (p.course.is_arc) {
    first = side_of_arc(p, true, b, theta0);
  }
  if (t.course.is_arc) {
    second = side_of_arc(t, false, -e, theta0);
    if (!p.course.is_arc) {
      first.available = std::min(p.length, p.nominal_length / 2);
    }
  } else if (p.course.is_arc) {
    second.available = t.nominal_length / 2;
  }
  if (p.course.is_arc || t.course.is_arc) {
    theta = half_angle(first.tangent, second.tangent);
    for (const Side* side : {static_cast<const Side*>(&first), static_cast<const Side*>(&second)}) {
      if (side->is_arc && side->convex) {
        theta = std::min(theta, theta0 - side->largest_turn / 4);
      }
    }
  }
  if (p.course.is_arc && t.course.is_arc && theta < least_of_arcs) {
    return std::nullopt;
  }
  const double phi = pi - 2 * theta;
  Vec3 normal = first.tangent.cross(second.tangent);
  if (!(normal.norm() > 0)) {
    return std::nullopt;
  }
  normal.normalize();
  for (const LinuxCncSegment* arc : {&p, &t}) {
    if (arc->course.is_arc && std::abs(std::abs(arc->course.normal.dot(normal)) - 1) > 1e-6) {
      return std::nullopt;
    }
  }
  const AxisBound plane_acceleration = plane_limit(settings.acceleration, normal);
  const double acceleration = plane_acceleration.value;
  const AxisBound plane_velocity = plane_limit(settings.velocity, normal);
  const double plane_speed = plane_velocity.value;
  const auto tolerance_of = [](const LinuxCncSegment& s) {
    return std::min(s.tolerance > 0 ? s.tolerance : s.nominal_length / 4, s.nominal_length / 4);
  };
  const double tolerance = std::min(tolerance_of(p), tolerance_of(t));
  const double across = linuxcnc_across_share * acceleration;
  const bool both_lines = !p.course.is_arc && !t.course.is_arc;
  const Speeds speeds = speeds_of(p, t, settings, phi, plane_speed, both_lines);

  const double by_tolerance = std::cos(theta) * tolerance / (1 - std::sin(theta));
  const double d = std::min({first.available, second.available, by_tolerance});
  const double largest_radius = d * std::tan(theta);
  const double planned = std::min(std::sqrt(across * largest_radius), speeds.goal);
  const double along = acceleration / 2;
  const double reachable = std::min(std::sqrt(2 * along * d), planned) / along * planned;
  const double radius = std::max(planned * planned / across, std::min(reachable / phi, largest_radius));
  if (radius < 1e-12 || radius * phi < 1e-6) {
    return std::nullopt;
  }
  const Vec3 inside = (second.tangent - first.tangent).normalized();
  LinuxCncBlend blend;
  Vec3 center;
  if (both_lines) {
    center = joint + radius / std::sin(theta) * inside;
    blend.cut_first = blend.cut_second = radius / std::tan(theta);
  } else {
    const std::optional<Vec3> found = blend_center(first, second, joint, inside, radius);
    if (!found || (*found - joint).norm() - radius > tolerance) {
      return std::nullopt;
    }
    center = *found;
    const Vec3 from = touching_point(first, joint, center);
    const Vec3 to = touching_point(second, joint, center);
    (first.is_arc ? blend.turn_first : blend.cut_first) =
        first.is_arc ? turn_to(first, joint, from) : (from - joint).norm();
    (second.is_arc ? blend.turn_second : blend.cut_second) =
        second.is_arc ? turn_to(second, joint, to) : (to - joint).norm();
    if ((first.is_arc && blend.turn_first > first.largest_turn) ||
        (second.is_arc && blend.turn_second > second.largest_turn) || blend.cut_first > p.length ||
        blend.cut_second > t.length) {
      return std::nullopt;
    }
  }
  LinuxCncCourse before = p.course;
  LinuxCncCourse after = t.course;
  before.cut_end(blend.cut_first, blend.turn_first);
  after.cut_start(blend.cut_second, blend.turn_second);
  const Vec3 from = before.at(before.length);
  const Vec3 to = after.at(0);
  LinuxCncSegment& arc = blend.arc;
  LinuxCncCourse& course = arc.course;
  course.is_arc = true;
  course.center = center;
  course.radius = (from - center).norm();
  course.spoke = (from - center) / course.radius;
  course.normal = normal;
  const Vec3 end = (to - center).normalized();
  course.angle = std::atan2(course.spoke.cross(end).dot(normal), course.spoke.dot(end));
  if (!(course.angle > 0)) {
    return std::nullopt;
  }
  course.start = from;
  blend.consumes_first = !p.course.is_arc && !p.blends_before && !p.waits_for_spindle &&
                         before.length / planned < gap_cycles * settings.period;
  if (blend.consumes_first) {
    course.lead = before.length;
    course.start = before.start;
    course.direction = before.direction;
  }
  course.length = course.radius * course.angle + course.lead;
  arc.block = t.block;
  arc.is_blend = true;
  arc.joint = {p.block, joint, pi - 2 * theta0};
  arc.length = arc.nominal_length = course.length;
  arc.requested = speeds.requested;
  arc.largest = planned;
  arc.acceleration = acceleration;
  arc.acceleration_axis = plane_acceleration.axis;
  const bool is_feed = planned >= speeds.requested;
  const LinuxCncSegment& faster = std::min(p.requested, p.largest) > std::min(t.requested, t.largest) ? p : t;
  const bool by_corner = planned < speeds.goal;
  arc.speed_cause = is_feed     ? faster.speed_cause
                    : by_corner ? Cause{CauseKind::contour_tolerance}
                                : Cause{CauseKind::axis_velocity, plane_velocity.axis};
  arc.end = LinuxCncEnd::tangent;
  arc.tolerance = tolerance;
  return blend;
}

LinuxCncOverlap find_linuxcnc_overlap(const LinuxCncSegment& p, const LinuxCncSegment& t,
                                      const LinuxCncSettings& settings, bool only_in_overlap) {
  const double a_p = p.along_acceleration(only_in_overlap);
  const double a_t = t.along_acceleration(only_in_overlap);
  const auto reach = [&](const LinuxCncSegment& s, double a) {
    return std::min(std::sqrt(a * s.length * (s.finalised ? 1 : 0.5)), s.target(settings));
  };
  const double reach_p = reach(p, a_p);
  const double reach_t = reach(t, a_t);
  LinuxCncOverlap overlap;
  if (!(reach_p > 0) || !(reach_t > 0)) {
    return overlap;
  }
  const double time =
      std::min(std::min(p.length / reach_p, t.length / reach_t), std::max(reach_p / a_p, reach_t / a_t));
  overlap.first = std::min(reach_p, time * a_p);
  overlap.second = std::min(reach_t, time * a_t);
  const Vec3 in = p.course.flat_tangent(p.course.length);
  Vec3 out = t.course.flat_tangent(0);
  if (t.course.is_arc) {
    const double half = t.requested / 2;
    out = (out * t.reduced_acceleration(only_in_overlap) - half * half / t.course.radius * t.course.spoke)
              .normalized();
  }
  const double theta = half_angle(in, out);
  if (p.tolerance > 0 && std::cos(theta) > std::cos(pi / 2 - 0.001)) {
    const double most = 2 * std::sqrt(a_p * p.tolerance / std::cos(theta));
    overlap.first = std::min(overlap.first, most);
    overlap.second = std::min(overlap.second, most);
  }
  overlap.net = std::sin(theta) * (overlap.first + overlap.second) / 2;
  return overlap;
}

}  // namespace feedscope
