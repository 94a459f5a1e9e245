#include "core/analysis/explanation/joint_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/limits/axis_share.h"
#include "core/models/linuxcnc/linuxcnc_segment.h"

namespace feedscope {
namespace {

/// The formula whose value is closer to `reached`.
Formula nearer(Formula first, Formula second, double reached) {
  const bool is_first = std::abs(first.value() - reached) <= std::abs(second.value() - reached);
  return is_first ? std::move(first) : std::move(second);
}

}  // namespace

Formula speed_across_arc(const ElementCurve& curve, const Vec3& acceleration, double reached) {
  if (!curve.is_arc()) {
    return {};
  }
  const Vec3 normal = curve.arc.x.cross(curve.arc.y);
  const Vec3 in_plane = (Vec3::Ones() - normal.cwiseProduct(normal)).cwiseMax(0).cwiseSqrt();
  const AxisBound bound = axis_share(acceleration, in_plane);
  if (bound.axis < 0) {
    return {};
  }
  constexpr double across = linuxcnc_across_share;
  const auto with_share = [&](double share) {
    return Formula{FormulaId::shared_radial_acceleration,
                   {{Symbol::acceleration_share, -1, share},
                    {Symbol::axis_acceleration, bound.axis, acceleration[bound.axis]},
                    {Symbol::radius, -1, 1 / curve.arc.curvature()},
                    {Symbol::normal_part, bound.axis, in_plane[bound.axis]}}};
  };
  return nearer(with_share(across), with_share(across / 2), reached);
}

Formula acceleration_of_joints(const ElementCurve& curve, const Vec3& acceleration, double reached) {
  const AxisBound bound = axis_share(acceleration, curve.direction);
  if (curve.is_arc() || bound.axis < 0) {
    return {};
  }
  const Quantity limit{Symbol::axis_acceleration, bound.axis, acceleration[bound.axis]};
  const Quantity part{Symbol::tangent_part, bound.axis, std::abs(curve.direction[bound.axis])};
  constexpr double half = 0.5;
  return nearer({FormulaId::path_acceleration, {limit, part}},
                {FormulaId::shared_acceleration, {{Symbol::acceleration_share, -1, half}, limit, part}},
                reached);
}

std::optional<HalfTurn> half_turn(const BlendedPath& path, std::uint32_t element) {
  if (element == 0 || element >= path.size() || path.kind(element) == ElementKind::dwell ||
      path.kind(element - 1) == ElementKind::dwell) {
    return std::nullopt;
  }
  const double cosine = -path.curve(element - 1).direction.dot(path.curve(element).direction);
  const HalfTurn half{std::sqrt(std::max(0.0, (1 - cosine) / 2)), std::sqrt(std::max(0.0, (1 + cosine) / 2))};
  return half.cosine > 1e-6 ? std::optional(half) : std::nullopt;
}

}  // namespace feedscope
