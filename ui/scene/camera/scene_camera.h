#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ui/scene/camera/projection.h"

class vtkCamera;

namespace feedscope::ui {

/// Direction of the view.
enum class StandardView : std::uint8_t {
  iso,     ///< from right, front and above
  top,     ///< along -Z: X to the right, Y up
  front,   ///< along +Y: X to the right, Z up
  right,   ///< along -X: Y to the right, Z up
  bottom,  ///< along +Z: X to the right, Y down
  back,    ///< along -Y: X to the left, Z up
  left,    ///< along +X: Y to the left, Z up
};

/// The camera in the program's coordinates, as stored in a session.
struct CameraState {
  Vec3 focal = Vec3::Zero();  ///< at the centre of the view [mm]
  double azimuth = 0;         ///< of the eye about Z, from +X [rad]
  double elevation = 0;       ///< of the eye above the XY plane, from -pi/2 to pi/2 [rad]
  double height = 100;        ///< height of the view at the focal point [mm]
  bool perspective = false;
  bool fitted = false;  ///< follows the path and the window's size; focal and height are then ignored

  bool operator==(const CameraState&) const = default;
};

/// Camera on a turntable, as in CAM systems: Z never leans to a side. Standard views, fitting, and whether
/// the user has moved it since.
class SceneCamera {
 public:
  explicit SceneCamera(vtkCamera& camera);

  /// Turns to a standard view and discards the user's changes.
  void look(StandardView view);
  /// Makes the outline as large as possible in `room` outside of `covered` (fit_outline()). `outline`: of the
  /// contents in a projection [pixels]; parts of it, such as labels, may keep their size.
  void fit(int width, int height, const ScreenRectangle& room, const std::vector<ScreenRectangle>& covered,
           const std::function<std::vector<Vec2>(const Projection&)>& outline);
  /// Scales and moves so that `box` [scene units] fills `room` outside of `covered`; a box without extent is
  /// only moved.
  void fit_part(int width, int height, const Bounds& box, const ScreenRectangle& room,
                const std::vector<ScreenRectangle>& covered);
  /// True until the user turns, moves or zooms after a fit.
  bool fitted() const { return fitted_; }

  /// Turns about `pivot` [scene units]; angles of the eye [rad].
  void orbit(double azimuth, double elevation, const Vec3& pivot);
  /// Moves the contents by `shift` pixels.
  void pan(const Vec2& shift, int width, int height);
  /// Zooms so that the contents of `box` [pixels] fill `room`.
  void zoom_to_box(const ScreenRectangle& box, const ScreenRectangle& room, int width, int height);
  /// Enlarges by `factor`; the point at `about` [pixels] stays there.
  void zoom(double factor, const Vec2& about, int width, int height);
  void set_perspective(bool perspective);
  bool perspective() const { return perspective_; }

  CameraState state(const SceneFrame& frame) const;
  void set_state(const CameraState& state, const SceneFrame& frame);

  /// Sets clipping planes around the scene, from `front` in front of its origin to `behind` beyond it [scene
  /// units].
  void set_clipping(double front, double behind = 0);

  Projection projection(int width, int height) const { return {camera_, width, height}; }

 private:
  void apply();

  vtkCamera& camera_;
  Vec3 focal_ = Vec3::Zero();
  double azimuth_ = 0;
  double elevation_ = 0;
  double half_height_ = 1;  ///< of the view at the focal point [scene units]
  bool perspective_ = false;
  bool fitted_ = false;
};

}  // namespace feedscope::ui
