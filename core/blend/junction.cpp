#include "core/blend/junction.h"

#include <cmath>

#include "core/base/units.h"

namespace feedscope {

double turn_angle(const Vec3& in, const Vec3& out) {
  return 2 * std::atan2((out - in).norm(), (out + in).norm());
}

JunctionKind junction_kind(const Toolpath& toolpath, std::size_t i) {
  const Segment& before = toolpath.segments[i - 1];
  const Segment& after = toolpath.segments[i];
  if (before.kind == SegmentKind::dwell || after.kind == SegmentKind::dwell || before.rapid || after.rapid) {
    return JunctionKind::stop;
  }
  if (toolpath.path_control_of(i - 1).mode == PathMode::exact_stop) {
    return JunctionKind::stop;
  }
  const double turn = turn_angle(toolpath.tangent_at_end(i - 1), toolpath.tangent_at_start(i));
  if (turn >= units::pi - straight_angle) {
    return JunctionKind::stop;
  }
  if (before.kind == SegmentKind::line && after.kind == SegmentKind::line) {
    return turn <= straight_angle ? JunctionKind::pass : JunctionKind::corner;
  }
  return turn <= tangent_angle ? JunctionKind::pass : JunctionKind::arc_corner;
}

}  // namespace feedscope
