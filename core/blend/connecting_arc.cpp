#include "core/blend/connecting_arc.h"

#include <algorithm>
#include <cmath>

#include "core/blend/corner.h"
#include "core/blend/junction.h"

namespace feedscope {

ConnectingArc connecting_arc(const Vec3& corner, const Vec3& in, const Vec3& out, double shorter,
                             double tolerance) {
  ConnectingArc result;
  result.turn = turn_angle(in, out);
  const double tangent = std::tan(result.turn / 2);
  result.transition = std::min(tolerance, std::max(shorter / 2 - tolerance * tangent, shorter / 8));
  result.epsilon = result.transition * std::tan(result.turn / 4);
  result.arc = corner_arc(corner, in, out, result.transition);
  return result;
}

}  // namespace feedscope
