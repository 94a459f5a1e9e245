#pragma once

#include <array>
#include <span>
#include <vector>

#include "ui/scene/camera/projection.h"

namespace feedscope::ui {

/// The part of space that a projection shows in its window and a margin around it, in front of the eye.
/// Drawing is clipped to it, because close up nearly everything is far outside.
class ViewWindow {
 public:
  /// `margin`: fraction of the window's width and height, on each side.
  ViewWindow(const Projection& projection, double margin);

  /// The inner part of a convex polygon, or of the line between two points, by its corners [scene units];
  /// inner corners are unchanged. Empty if all is outside.
  std::vector<Vec3> clip(std::span<const Vec3> corners) const;

 private:
  /// n * (p - focal) + c is not negative inside.
  struct HalfSpace {
    Vec3 n;
    double c;
  };
  Vec3 focal_;
  std::vector<HalfSpace> bounds_;
};

}  // namespace feedscope::ui
