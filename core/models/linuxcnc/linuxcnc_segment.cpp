#include "core/models/linuxcnc/linuxcnc_segment.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

LinuxCncCourse LinuxCncCourse::line(const Vec3& from, const Vec3& to) {
  LinuxCncCourse course;
  course.start = from;
  course.length = (to - from).norm();
  course.direction = course.length > 0 ? Vec3((to - from) / course.length) : Vec3(Vec3::Zero());
  return course;
}

double LinuxCncCourse::arc_length() const {
  const double mean = radius + spiral / 2;
  const double turn = std::hypot(mean * angle, spiral);
  return std::hypot(turn, height);
}

Vec3 LinuxCncCourse::at(double s) const {
  if (!is_arc || s < lead) {
    return start + s * direction;
  }
  const double share = length > lead ? (s - lead) / (length - lead) : 1;
  const double turned = share * angle;
  const Vec3 side = normal.cross(spoke);
  return center + (radius + share * spiral) * (std::cos(turned) * spoke + std::sin(turned) * side) +
         share * height * normal;
}

Vec3 LinuxCncCourse::tangent(double s) const {
  if (!is_arc || s < lead) {
    return direction;
  }
  const double share = length > lead ? (s - lead) / (length - lead) : 1;
  const double turned = share * angle;
  const Vec3 side = normal.cross(spoke);
  const Vec3 out = std::cos(turned) * spoke + std::sin(turned) * side;
  const Vec3 along = normal.cross(out);
  return (spiral / angle * out + (radius + share * spiral) * along + height / angle * normal).normalized();
}

Vec3 LinuxCncCourse::flat_tangent(double s) const {
  if (!is_arc || s < lead) {
    return direction;
  }
  const double turned = length > lead ? (s - lead) / (length - lead) * angle : angle;
  return std::cos(turned) * normal.cross(spoke) - std::sin(turned) * spoke;
}

double LinuxCncCourse::effective_radius() const {
  const double r = std::min(radius, radius + spiral);
  const double slope = spiral / angle;
  const double n = slope * slope + r * r;
  const double of_spiral = n * std::sqrt(n) / (n + slope * slope);
  return of_spiral + height * height / of_spiral;  // of the whole helix, not per radian
}

void LinuxCncCourse::cut_end(double way, double turn) {
  if (!is_arc) {
    length -= way;
    return;
  }
  const double share = 1 - turn / angle;
  spiral *= share;
  height *= share;
  angle -= turn;
  length = lead + arc_length();
}

void LinuxCncCourse::cut_start(double way, double turn) {
  if (!is_arc) {
    start += way * direction;
    length -= way;
    return;
  }
  const double share = turn / angle;
  const Vec3 side = normal.cross(spoke);
  center += share * height * normal;
  spoke = (std::cos(turn) * spoke + std::sin(turn) * side).normalized();
  radius += share * spiral;
  spiral *= 1 - share;
  height *= 1 - share;
  angle -= turn;
  start = center + radius * spoke;
  length = lead + arc_length();
}

double LinuxCncSegment::reduced_acceleration(bool only_in_overlap) const {
  const bool halved = only_in_overlap ? in_overlap : end == LinuxCncEnd::parabolic || blends_before;
  return acceleration * (1 - std::max(kink_share_next, kink_share_before)) * (halved ? 0.5 : 1);
}

double LinuxCncSegment::along_acceleration(bool only_in_overlap) const {
  return reduced_acceleration(only_in_overlap) * (course.is_arc ? tangential_ratio : 1);
}

void LinuxCncSegment::limit_arc() {
  if (!course.is_arc) {
    return;
  }
  const double all = reduced_acceleration();
  const double radius = course.effective_radius();
  const double most = linuxcnc_across_share * all;
  const double across = largest * largest / radius;
  if (across > most) {
    lower_largest(std::sqrt(most * radius), {CauseKind::radial_acceleration});
    tangential_ratio = 0.5;
  } else {
    tangential_ratio = std::sqrt(1 - across * across / (all * all));
  }
}

void LinuxCncSegment::finalise(double period) {
  if (finalised) {
    return;
  }
  lower_largest(length / period, {CauseKind::interpolation_period});
  limit_arc();
  finalised = true;
}

void LinuxCncSegment::lower_largest(double speed, Cause by) {
  if (speed < std::min(largest, requested)) {
    speed_cause = by;
  }
  largest = std::min(largest, speed);
}

double LinuxCncSegment::target(const LinuxCncSettings& settings) const {
  return std::min({requested, requested * settings.max_override, largest, settings.max_velocity});
}

Cause LinuxCncSegment::cause(const LinuxCncSettings& settings) const {
  return settings.max_velocity < std::min(requested, largest) ? Cause{CauseKind::path_velocity} : speed_cause;
}

}  // namespace feedscope
