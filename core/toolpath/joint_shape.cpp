#include "core/toolpath/joint_shape.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// k t^3 + m t^4 and its derivatives by the path, where t changes by `rate` [1/mm].
Series rising(double k, double m, double t, double rate) {
  return {t * t * t * (k + m * t), t * t * (3 * k + 4 * m * t) * rate, t * (6 * k + 12 * m * t) * rate * rate,
          (6 * k + 24 * m * t) * rate * rate * rate};
}

}  // namespace

Series joint_shape(double before, double behind, double away) {
  constexpr double rounding = 1e-9;  // of a place at an end of the reach
  const bool comes = std::signbit(away);
  const double reach = comes ? before : behind;
  const double t = 1 - std::abs(away) / reach;
  if (t < -rounding) {
    return {};
  }
  const double longer = (before * before - behind * behind) / (2 * behind * behind);
  const double a = 1 / ((3 + 4 * longer) / before + (3 + 2 * longer) / behind);
  const double b = a * longer;
  return comes ? rising(a, b, std::max(t, 0.0), 1 / reach)
               : rising(a + 2 * b, -b, std::max(t, 0.0), -1 / reach);
}

Series joint_turn(const TurnJoint& joint, std::size_t axis, double away) {
  const double step = joint.step[axis];
  if (!(joint.before > 0) || step == 0) {
    return {};
  }
  const Series shape = joint_shape(joint.before, joint.behind, away);
  return {step * shape.value(), step * shape.d1(), step * shape.d2(), step * shape.d3()};
}

}  // namespace feedscope
