#include "tests/support/paths.h"

#include <cmath>

#include "core/base/units.h"

namespace feedscope::testing {
namespace {

Segment make_segment(const Toolpath& path, const Vec3& end, double feed) {
  Segment segment;
  segment.end = end;
  segment.feed = feed;
  segment.line = static_cast<std::uint32_t>(path.segments.size() + 1);
  return segment;
}

const Vec3& last_point(const Toolpath& path) {
  return path.segments.empty() ? path.start : path.segments.back().end;
}

}  // namespace

void append_line(Toolpath& path, const Vec3& end, double feed) {
  Segment segment = make_segment(path, end, feed);
  segment.length = (end - last_point(path)).norm();
  path.segments.push_back(segment);
}

void append_arc(Toolpath& path, const Vec3& center, double sweep, double feed) {
  const Vec3 from = last_point(path) - center;
  Arc arc;
  arc.center = center;
  arc.radius = from.norm();
  arc.x = from / arc.radius;
  arc.y = Vec3(-arc.x.y(), arc.x.x(), 0) * (sweep > 0 ? 1 : -1);
  arc.rise = Vec3::Zero();
  arc.sweep = std::abs(sweep);
  Segment segment = make_segment(path, arc.at(arc.length()).position, feed);
  segment.kind = SegmentKind::arc;
  segment.length = arc.length();
  segment.index = static_cast<std::int32_t>(path.arcs.size());
  path.arcs.push_back(arc);
  path.segments.push_back(segment);
}

void append_dwell(Toolpath& path, double time) {
  Segment dwell = make_segment(path, last_point(path), 0);
  dwell.kind = SegmentKind::dwell;
  dwell.index = static_cast<std::int32_t>(path.pauses.size());
  path.pauses.push_back({time, Pause::dwell, true, 0});
  path.segments.push_back(dwell);
}

Toolpath polyline(const std::vector<Vec3>& points, double feed) {
  Toolpath path;
  path.start = points.front();
  for (std::size_t i = 1; i < points.size(); ++i) {
    append_line(path, points[i], feed);
  }
  return path;
}

Toolpath spiral(double radius, double step, int count, double from, double sweep, double feed) {
  Toolpath path;
  path.start = radius * Vec3(std::cos(from), std::sin(from), 0);
  Vec3 center = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    append_arc(path, center, sweep, feed);
    const double end = from + (i + 1) * sweep;
    center -= step * Vec3(std::cos(end), std::sin(end), 0);
  }
  return path;
}

Toolpath random_path(std::mt19937& random, int blocks) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto symmetric = [&] { return 2 * unit(random) - 1; };
  Toolpath path;
  path.start = Vec3(symmetric(), symmetric(), symmetric()) * 50;
  Vec3 direction(1, 0, 0);
  double feed = units::from_mm_min(std::pow(10, 4.8 * unit(random)));
  double size = std::pow(10, 4 * unit(random) - 2);
  for (int i = 0; i < blocks; ++i) {
    if (unit(random) < 0.05) {
      feed = units::from_mm_min(std::pow(10, 4.8 * unit(random)));
    }
    if (unit(random) < 0.1) {
      size = std::pow(10, 4 * unit(random) - 2);
    }
    const double choice = unit(random);
    if (choice < 0.1) {  // collinear: as it was
    } else if (choice < 0.14) {
      direction = -direction;
    } else {
      const double wildness = std::pow(10, 3 * unit(random) - 3);
      direction = (direction + wildness * Vec3(symmetric(), symmetric(), symmetric())).normalized();
    }
    if (choice > 0.9) {
      const Vec3 flat = Vec3(direction.y(), -direction.x(), 0);
      if (flat.norm() > 0.1) {
        const double sweep = (0.1 + 6.1 * unit(random)) * (unit(random) < 0.5 ? 1 : -1);
        append_arc(path, last_point(path) - flat.normalized() * size * (sweep > 0 ? 1 : -1), sweep, feed);
        direction = path.tangent_at_end(path.segments.size() - 1);
        continue;
      }
    }
    append_line(path, last_point(path) + direction * size * (0.2 + unit(random)), feed);
    path.segments.back().rapid = choice > 0.14 && choice < 0.16;
  }
  return path;
}

Machine spinner() {
  Machine machine;
  machine.id = "spinner-mvc850";
  for (AxisLimits& axis : machine.axes) {
    axis = {units::from_m_min(20), units::from_m(1), units::from_m(15), units::from_m(10)};
  }
  return machine;
}

Machine mikron() {
  Machine machine;
  machine.id = "mikron-ucp710";
  machine.axes[0] = {units::from_m_min(30), units::from_m(2.5), units::from_m(5), units::from_m(5)};
  machine.axes[1] = {units::from_m_min(30), units::from_m(3), units::from_m(5), units::from_m(5)};
  machine.axes[2] = {units::from_m_min(30), units::from_m(2.1), units::from_m(50), units::from_m(50)};
  machine.settings.set("interpolation_period_s", 0.012);
  machine.settings.set("curvilinear_jerk_m_s3", 10.0);
  machine.settings.set("tangential_share", 0.6);
  return machine;
}

Settings spinner_settings(const ControlModel& model) {
  Settings settings = complete_settings(model, spinner());
  settings.set("contour_tolerance_mm", 0.1);
  settings.set("interpolation_period_s", 0.001);
  settings.set("lookahead_blocks", 8.0);
  settings.set("radial_acceleration_share", 0.2);
  settings.set("radial_jerk_share", 0.2);
  return settings;
}

std::vector<Vec3> essid_table1() {
  return {{0, 0, 0}, {7.071, 7.071, 0}, {9.659, 16.73, 0}, {19.318, 14.142, 0}, {26.389, 21.213, 0}};
}

std::vector<Vec3> essid_spline() {
  std::vector<Vec3> points;
  for (const double u :
       {0.0, .081838, .165539, .266221, .432464, .614478, .717193, .801479, .883121, .970499, 1.0}) {
    points.push_back({100 * u, 100 * (3 * u * u * u - 4 * u * u + u), 0});
  }
  return points;
}

}  // namespace feedscope::testing
