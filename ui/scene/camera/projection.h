#pragma once

#include <Eigen/Core>

#include "core/base/geometry.h"

class vtkCamera;

namespace feedscope::ui {

/// Display coordinates: device pixels from the window's lower left corner, as in VTK.
using Vec2 = Eigen::Vector2d;

/// A rectangle of the window [pixels], upwards; empty if it has no height.
struct ScreenRectangle {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();

  bool empty() const { return high.y() <= low.y(); }
  Vec2 size() const { return high - low; }
  Vec2 centre() const { return (low + high) / 2; }
  /// Enlarged by `more` on every side.
  ScreenRectangle grown(double more) const {
    return {low - Vec2::Constant(more), high + Vec2::Constant(more)};
  }
  bool meets(const ScreenRectangle& other) const {
    return (low.array() < other.high.array()).all() && (other.low.array() < high.array()).all();
  }
  bool contains(const ScreenRectangle& other) const {
    return (low.array() <= other.low.array()).all() && (other.high.array() <= high.array()).all();
  }
};

/// Scaled coordinates of the program's space: VTK's matrices and depth buffer are single precision, so the
/// scene is drawn about its centre with a largest extent of 1, be it a micrometre or a kilometre.
struct SceneFrame {
  Vec3 centre = Vec3::Zero();  ///< [mm]
  double unit = 1;             ///< [mm]
  Bounds box;                  ///< of the axes, in scene coordinates

  Vec3 to_scene(const Vec3& point) const { return (point - centre) / unit; }
  double to_mm(int axis, double coordinate) const { return centre[axis] + coordinate * unit; }
};

/// Frame around `content` [mm] with a small margin; a flat extent remains flat, a single point or nothing
/// gets a plane of 100 mm.
SceneFrame frame_around(const Bounds& content);

/// Projection of one frame, from scene coordinates to the window.
struct Projection {
  Vec3 focal;  ///< drawn at the centre of the window
  Vec3 right;  ///< unit vectors of the screen, in the scene
  Vec3 up;
  Vec3 towards;             ///< from the focal point to the eye
  double scale = 1;         ///< pixels per scene unit, at the focal point
  double eye_distance = 0;  ///< from the focal point; 0: parallel projection
  Vec2 middle;              ///< centre of the window

  Projection(vtkCamera& camera, int width, int height);

  bool perspective() const { return eye_distance > 0; }
  /// Size of things at `p` relative to the focal point; behind the eye or very near, the value just in front
  /// of it.
  double magnification(const Vec3& p) const;
  Vec2 to_display(const Vec3& p) const {
    return middle + scale * magnification(p) * Vec2((p - focal).dot(right), (p - focal).dot(up));
  }
  /// Unit vector from `p` to the eye.
  Vec3 towards_eye(const Vec3& p) const;
  /// Moves something `height` scene units towards the eye without moving it on the screen: a point p moves to
  /// shift + shrink * p.
  struct Lift {
    Vec3 shift;
    double shrink = 1;
  };
  Lift lift(double height) const;
};

}  // namespace feedscope::ui
