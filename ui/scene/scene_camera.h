#pragma once

#include <functional>
#include <optional>

#include "ui/scene/path_scene.h"
#include "ui/scene/projection.h"

class vtkCamera;

namespace feedscope::ui {

/// A rectangle of the window [pixels].
struct ScreenRectangle {
  Vec2 low, high;
};

/// Moves the camera of the scene: standard views, fitting, and whether the user has moved it since.
class SceneCamera {
 public:
  explicit SceneCamera(vtkCamera& camera);

  /// Turns to a standard view and forgets what the user did.
  void look(StandardView view);
  /// Centres and scales so that everything `extent` gives fills `room`. `extent`: the rectangle covered under
  /// a projection, labels included; `box`: that of the scene alone, in scene units.
  void fit(int width, int height, const Bounds& box, const ScreenRectangle& room,
           const std::function<ScreenRectangle(const Projection&)>& extent);
  /// True until the user turns, moves or zooms after a fit.
  bool fitted() const;
  /// Encloses the scene about its origin, lifted by up to `front` towards the eye [scene units].
  void set_clipping(double front);

  Projection projection(int width, int height) const { return {camera_, width, height}; }

 private:
  struct Pose {
    Vec3 focal, position, up;
    double parallel_scale = 0;
    bool operator==(const Pose&) const = default;
  };
  Pose pose() const;
  void place(const Vec3& focal, const Vec3& towards);

  vtkCamera& camera_;
  std::optional<Pose> fitted_;
};

}  // namespace feedscope::ui
