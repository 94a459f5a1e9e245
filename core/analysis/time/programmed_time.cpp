#include "core/analysis/time/programmed_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/exact_sum.h"

namespace feedscope {
namespace {

constexpr int arc_time_samples = 64;

/// Speed along `direction` (unit) at which the first axis reaches its rapid speed [mm/s].
double axes_speed(const Vec3& direction, const Vec3& rapid_speed) {
  double speed = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] != 0) {
      speed = std::min(speed, rapid_speed[axis] / std::abs(direction[axis]));
    }
  }
  return speed;
}

double time_at_axes_speed(const Toolpath& toolpath, std::size_t index, const Vec3& rapid_speed) {
  const Segment& segment = toolpath.segments[index];
  if (segment.kind == SegmentKind::line) {
    return segment.length /
           axes_speed((segment.end - toolpath.start_of(index)) / segment.length, rapid_speed);
  }
  const Arc& arc = toolpath.arc_of(segment);
  const double step = segment.length / arc_time_samples;
  double time = 0;
  for (int i = 0; i < arc_time_samples; ++i) {
    time += step / axes_speed(arc.at((i + 0.5) * step).d1.normalized(), rapid_speed);
  }
  return time;
}

}  // namespace

double programmed_time(const Toolpath& toolpath, std::size_t index, const Vec3& rapid_speed) {
  const Segment& segment = toolpath.segments[index];
  if (segment.kind == SegmentKind::dwell) {
    return toolpath.dwell_of(segment);
  }
  if (segment.length == 0) {
    return 0;  // no direction
  }
  return !segment.rapid && segment.feed > 0 ? segment.length / segment.feed
                                            : time_at_axes_speed(toolpath, index, rapid_speed);
}

double programmed_time(const Toolpath& toolpath, const Vec3& rapid_speed) {
  ExactSum time;
  for (std::size_t i = 0; i < toolpath.segments.size(); ++i) {
    time.add(programmed_time(toolpath, i, rapid_speed));
  }
  return time.value();
}

}  // namespace feedscope
