#include "core/blend/junction.h"

#include <cmath>

namespace feedscope {

double turn_angle(const Vec3& in, const Vec3& out) {
  return 2 * std::atan2((out - in).norm(), (out + in).norm());
}

namespace {

/// Whether turn_angle(in, out) <= angle, without an arc tangent. `difference`, `sum`: |out - in|^2, |out +
/// in|^2.
bool turns_at_most(double difference, double sum, double tan_of_half) {
  return difference <= sum * (tan_of_half * tan_of_half);
}

}  // namespace

JunctionKind junction_kind(const Toolpath& toolpath, std::size_t i) {
  const Segment& before = toolpath.segments[i - 1];
  const Segment& after = toolpath.segments[i];
  if (before.kind == SegmentKind::dwell || after.kind == SegmentKind::dwell || before.rapid || after.rapid) {
    return JunctionKind::stop;
  }
  if (toolpath.path_control_of(i - 1).mode == PathMode::exact_stop) {
    return JunctionKind::stop;
  }
  static const double straight = std::tan(straight_angle / 2);
  static const double tangent = std::tan(tangent_angle / 2);
  const Vec3 in = toolpath.tangent_at_end(i - 1);
  const Vec3 out = toolpath.tangent_at_start(i);
  const double difference = (out - in).squaredNorm();
  const double sum = (out + in).squaredNorm();
  if (turns_at_most(sum, difference, straight)) {  // a reversal
    return JunctionKind::stop;
  }
  if (before.kind == SegmentKind::line && after.kind == SegmentKind::line) {
    return turns_at_most(difference, sum, straight) ? JunctionKind::pass : JunctionKind::corner;
  }
  return turns_at_most(difference, sum, tangent) ? JunctionKind::pass : JunctionKind::arc_corner;
}

}  // namespace feedscope
