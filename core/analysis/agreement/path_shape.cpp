#include "core/analysis/agreement/path_shape.h"

#include <algorithm>

namespace feedscope {

std::vector<Vec3> shape_of(const std::vector<Vec3>& places, double least_step) {
  constexpr std::size_t shape_points = 500;
  std::vector<Vec3> kept;
  for (const Vec3& place : places) {
    if (kept.empty() || (place - kept.back()).norm() >= least_step) {
      kept.push_back(place);
    }
  }
  std::vector<double> way{0};
  for (std::size_t i = 1; i < kept.size(); ++i) {
    way.push_back(way.back() + (kept[i] - kept[i - 1]).norm());
  }
  std::vector<Vec3> shape;
  if (way.back() <= 0) {
    return shape;
  }
  std::size_t i = 1;
  for (std::size_t k = 0; k < shape_points; ++k) {
    const double at = way.back() * static_cast<double>(k) / static_cast<double>(shape_points - 1);
    while (i + 1 < way.size() && way[i] < at) {
      ++i;
    }
    const double share = (at - way[i - 1]) / (way[i] - way[i - 1]);
    shape.push_back(kept[i - 1] + std::clamp(share, 0.0, 1.0) * (kept[i] - kept[i - 1]));
  }
  return shape;
}

double mean_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    sum += (a[i] - b[i]).norm();
  }
  return a.empty() ? 0 : sum / static_cast<double>(a.size());
}

Bounds bounds_of(const std::vector<Vec3>& places) {
  Bounds bounds;
  for (const Vec3& place : places) {
    bounds.add(place);
  }
  return bounds;
}

}  // namespace feedscope
