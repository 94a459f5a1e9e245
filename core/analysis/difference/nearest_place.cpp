#include "core/analysis/difference/nearest_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope {
namespace {

constexpr double nowhere = 1e-9;  ///< nearer places are the same [mm]

}  // namespace

/// Newton steps from `start` within `range`; `curve(u)` returns position, first and second derivative.
template <typename Curve>
void NearestPlace::descend(const Curve& curve, double start, Range range) {
  constexpr int max_steps = 12;
  double u = std::clamp(start, range.low, range.high);
  for (int step = 0; step < max_steps; ++step) {
    const auto at = curve(u);
    const Vec3 offset = at.position - place_;
    squared_ = std::min(squared_, offset.squaredNorm());
    const double slope = offset.dot(at.d1);
    const double straight = at.d1.squaredNorm();
    const double bend = straight + offset.dot(at.d2);
    if (!(straight > 0)) {
      return;
    }
    const double next = std::clamp(u - slope / (bend > 0 ? bend : straight), range.low, range.high);
    if (std::abs(next - u) <= 1e-12 * (range.high - range.low)) {
      return;
    }
    u = next;
  }
}

void NearestPlace::try_element(std::uint32_t element, Range range) {
  const ElementCurve curve = trajectory_.path().curve(element);
  if (curve.kind == ElementKind::dwell) {
    return;
  }
  const auto point = [&](double u) {
    return curve.kind == ElementKind::blend ? curve.blend.at(u) : curve.at(u);
  };
  if (curve.kind == ElementKind::blend) {
    range = {0, 1};
  }
  if (!(range.high > range.low)) {
    return;
  }
  const bool line = curve.kind == ElementKind::line;
  for (const double share : {0.5, 0.0, 1.0}) {
    descend(point, std::lerp(range.low, range.high, share), range);
    if (line) {
      break;
    }
  }
}

/// Searches the element and its neighbours, `reach` of path length on either side of `at` [mm].
void NearestPlace::search_elements(std::uint32_t element, double at, double reach) {
  const BlendedPath& path = trajectory_.path();
  const double s = path.s(element) + at;
  const auto part_of = [&](std::size_t i) {
    const double start = path.s(i);
    return Range{std::max(0.0, s - reach - start), std::min(path.length(i), s + reach - start)};
  };
  try_element(element, part_of(element));
  for (std::size_t i = element + std::size_t{1}; i < path.size() && path.s(i) < s + reach; ++i) {
    try_element(static_cast<std::uint32_t>(i), part_of(i));
  }
  for (std::size_t i = element; i > 0 && path.s(i) > s - reach; --i) {
    try_element(static_cast<std::uint32_t>(i - 1), part_of(i - 1));
  }
}

void NearestPlace::try_filtered(const FilteredMotion& motion, Range range) {
  struct Point {
    Vec3 position, d1, d2;
  };
  const auto point = [&](double time) {
    const Kinematics at = filters_.at(motion.train(), time - motion.start());
    return Point{at.position, at.velocity, at.acceleration};
  };
  for (const double share : {0.5, 0.0, 1.0}) {
    descend(point, std::lerp(range.low, range.high, share), range);
  }
}

double NearestPlace::distance(const Vec3& place, const Part& part, double tau) {
  place_ = place;
  const PartMotion motion(trajectory_, part, part.law == Law::filtered ? &filters_ : nullptr);
  const Kinematics there = motion.kinematics(tau);
  squared_ = (there.position - place).squaredNorm();
  const double away = std::sqrt(squared_);
  if (away <= nowhere) {
    return away;
  }
  const double reach = 2 * away;
  if (part.law == Law::filtered) {
    const FilteredMotion& filtered = trajectory_.motion_of(part.element);
    const double speed = there.velocity.norm();
    const double time = part.time + tau;
    const double most = filtered.delay();
    const double within = speed * most > reach ? reach / speed : most;
    try_filtered(filtered, {std::max(filtered.start(), time - within),
                            std::min(filtered.start() + filtered.duration(), time + within)});
  } else {
    const double q = advance({part.q, part.v, part.a, part.j}, tau).q;
    const double length = trajectory_.path().length(part.element);
    search_elements(part.element, part.law == Law::parameter ? q * length : q, reach);
  }
  return std::sqrt(squared_);
}

}  // namespace feedscope
