#include "ui/scene/path/shown_extent.h"

#include <algorithm>

namespace feedscope::ui {

namespace {

Bounds near_cutting(const Bounds& cutting, const Bounds& all) {
  constexpr double close = 0.2;  // of the largest extent of the cut path
  const double reach = cutting.empty() ? 0 : close * (cutting.max - cutting.min).maxCoeff();
  if (!(reach > 0)) {
    return all;
  }
  Bounds near = cutting;
  near.add(all.min.cwiseMax(cutting.min - Vec3::Constant(reach)));
  near.add(all.max.cwiseMin(cutting.max + Vec3::Constant(reach)));
  return near;
}

}  // namespace

Bounds cut_bounds(const SampledPath& path) {
  Bounds bounds;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] != SpanKind::rapid && path.kinds[i] != SpanKind::gap) {
      bounds.add(path.position(i));
      bounds.add(path.position(i + 1));
    }
  }
  return bounds;
}

double ShownExtent::beyond() const {
  return all.empty() ? 0 : (fitted.min - all.min).cwiseMax(all.max - fitted.max).norm();
}

ShownExtent shown_extent(std::initializer_list<std::shared_ptr<const SampledPath>> paths) {
  ShownExtent extent;
  Bounds cutting;
  for (const auto& path : paths) {
    if (path && !path->bounds.empty()) {
      extent.all.add(path->bounds.min);
      extent.all.add(path->bounds.max);
      if (const Bounds cut = cut_bounds(*path); !cut.empty()) {
        cutting.add(cut.min);
        cutting.add(cut.max);
      }
    }
  }
  extent.fitted = near_cutting(cutting, extent.all);
  return extent;
}

std::vector<Vec3> outline_points(std::initializer_list<std::shared_ptr<const SampledPath>> paths,
                                 const Bounds& near, bool rapids) {
  constexpr std::size_t enough_points = 50'000;
  std::vector<Vec3> points;
  bool cuts = false;
  for (const auto& path : paths) {
    if (!path) {
      continue;
    }
    const PathLevel all{0, path->size(), {}};
    const auto& levels = path->levels;
    const auto enough =
        std::ranges::find_if(levels, [](const PathLevel& level) { return level.size() <= enough_points; });
    const PathLevel& level = levels.empty() ? all : enough == levels.end() ? levels.back() : *enough;
    bool before = false;  // the span that ends here is cut
    for (std::size_t k = 0; k < level.size(); ++k) {
      const SpanKind kind = path->kinds[level[k]];
      const bool cut = k + 1 < level.size() && kind != SpanKind::rapid && kind != SpanKind::gap;
      cuts = cuts || cut;
      const Vec3 point = path->position(level[k]);
      if (cut || before) {
        points.push_back(point);
      } else if (rapids) {
        points.emplace_back(point.cwiseMax(near.min).cwiseMin(near.max));
      }
      before = cut;
    }
  }
  return cuts || rapids ? points : outline_points(paths, near, true);
}

}  // namespace feedscope::ui
