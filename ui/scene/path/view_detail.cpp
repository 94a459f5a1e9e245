#include "ui/scene/path/view_detail.h"

#include <algorithm>

namespace feedscope::ui {

namespace {

constexpr std::size_t points_moving = 10'000;  // drawn of a path while the view moves

}  // namespace

double crowding(const SceneFrame& frame, const Projection& view, double drawn) {
  const Vec3 size = frame.box.max - frame.box.min;
  const Vec3 faces(size.y() * size.z(), size.z() * size.x(), size.x() * size.y());
  const Vec2 across(size.dot(view.right.cwiseAbs()), size.dot(view.up.cwiseAbs()));
  constexpr double min_share = 0.15;  // of the square over its extent, for a box seen from its edge
  const double area = view.scale * view.scale *
                      std::max(faces.dot(view.towards.cwiseAbs()), min_share * across.squaredNorm());
  return drawn * view.scale / frame.unit / std::max(area, 1.0);
}

std::size_t level_of(const SampledPath& path, const SceneFrame& frame, const Projection& view, bool moving) {
  constexpr double invisible = 0.7;  // [pixels]
  const auto& levels = path.levels;
  std::size_t level = 0;
  while (level + 1 < levels.size() && (levels[level + 1].spacing / frame.unit * view.scale < invisible ||
                                       (moving && levels[level].size() > points_moving))) {
    ++level;
  }
  return level;
}

}  // namespace feedscope::ui
