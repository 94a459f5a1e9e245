#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ui/scene/camera/scene_camera.h"
#include "ui/scene/draw/canvas.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// A cube that turns with the scene, with standard views on its faces.
class AxesCube {
 public:
  /// `half`: half the length of an edge [pixels].
  AxesCube(const Projection& projection, const Vec2& centre, double half);

  void draw(Canvas& canvas, double scale, const SceneColours& colours) const;
  /// The view of the face at a place.
  std::optional<StandardView> view_at(const Vec2& place) const;

 private:
  struct Face {
    StandardView view = StandardView::top;
    std::vector<Vec2> corners;  ///< anticlockwise
    double facing = 0;          ///< 1: straight towards the eye
  };

  struct Edge {
    Vec2 low, high;  ///< ends of the axis
  };

  std::optional<Edge> outer_edge(int axis) const;
  Vec2 at(const Vec3& p) const { return centre_ + half_ * Vec2(p.dot(right_), p.dot(up_)); }
  void draw_axis(Canvas& canvas, int axis, double scale, const SceneColours& colours) const;

  Vec3 right_, up_, towards_;
  Vec2 centre_;
  double half_;
  std::vector<Face> faces_;  ///< visible ones
};

}  // namespace feedscope::ui
