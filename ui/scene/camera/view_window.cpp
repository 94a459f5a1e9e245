#include "ui/scene/camera/view_window.h"

#include <utility>

namespace feedscope::ui {

// A point q from the focal point is drawn at scale / d * (right * q, up * q) from the centre of the window,
// with d = 1 - towards * q / eye distance, which is 1 in a parallel projection. Points within w pixels of the
// centre thus satisfy w d - scale (right * q) >= 0, which is linear in q, as long as d is positive.
ViewWindow::ViewWindow(const Projection& projection, double margin) : focal_(projection.focal) {
  constexpr double nearest = 0.02;  // of the eye's distance, as Projection::magnification
  const Vec3 fall =
      projection.perspective() ? Vec3(-projection.towards / projection.eye_distance) : Vec3::Zero();
  const Vec2 half = (1 + 2 * margin) * projection.middle;
  for (const double sign : {-1.0, 1.0}) {
    bounds_.push_back({half.x() * fall + sign * projection.scale * projection.right, half.x()});
    bounds_.push_back({half.y() * fall + sign * projection.scale * projection.up, half.y()});
  }
  if (projection.perspective()) {
    bounds_.push_back({fall, 1 - nearest});
  }
}

std::vector<Vec3> ViewWindow::clip(std::span<const Vec3> corners) const {
  std::vector<Vec3> left(corners.begin(), corners.end());
  std::vector<Vec3> inside;
  for (const HalfSpace& bound : bounds_) {
    const auto height = [&](const Vec3& p) { return bound.n.dot(p - focal_) + bound.c; };
    inside.clear();
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Vec3& from = left[i];
      const Vec3& to = left[(i + 1) % left.size()];
      const double a = height(from);
      const double b = height(to);
      if (a >= 0) {
        inside.push_back(from);
      }
      if ((a < 0) != (b < 0)) {
        inside.push_back(from + a / (a - b) * (to - from));
      }
    }
    std::swap(left, inside);
  }
  return left;
}

}  // namespace feedscope::ui
