#include "ui/scene/camera/scene_camera.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "ui/scene/camera/fit_outline.h"

namespace feedscope::ui {
namespace {

constexpr double parallel_eye_distance =
    40;  // scene units; a parallel projection shows the same from anywhere
constexpr double scene_radius = 1.5;
constexpr double view_angle = units::pi / 6;  // of a perspective view, vertical
constexpr double quarter = units::pi / 2;
// Half of the view's height: smaller exceeds single precision, larger shows a dot.
constexpr double min_half_height = 1e-6;
constexpr double largest_half_height = 100;

struct Angles {
  double azimuth, elevation;
};

Angles angles_of(StandardView view) {
  switch (view) {
    case StandardView::top:
      return {-quarter, quarter};
    case StandardView::bottom:
      return {-quarter, -quarter};
    case StandardView::front:
      return {-quarter, 0};
    case StandardView::back:
      return {quarter, 0};
    case StandardView::right:
      return {0, 0};
    case StandardView::left:
      return {units::pi, 0};
    case StandardView::iso:
      break;
  }
  return {-quarter / 2, std::atan(std::sqrt(0.5))};
}

/// Sine and cosine, exact at quarter turns: standard views look exactly along an axis.
Vec2 sine_cosine(double angle) {
  const double quarters = angle / quarter;
  const double whole = std::round(quarters);
  if (std::abs(quarters - whole) > 1e-12) {
    return {std::sin(angle), std::cos(angle)};
  }
  switch (((static_cast<int>(whole) % 4) + 4) % 4) {
    case 0:
      return {0, 1};
    case 1:
      return {1, 0};
    case 2:
      return {0, -1};
    default:
      return {-1, 0};
  }
}

/// The axes of the screen in the scene.
struct Axes {
  Vec3 right, up, towards;
};

Axes axes_of(double azimuth, double elevation) {
  const Vec2 a = sine_cosine(azimuth);
  const Vec2 e = sine_cosine(elevation);
  return {Vec3(-a[0], a[1], 0), Vec3(-e[0] * a[1], -e[0] * a[0], e[1]), Vec3(e[1] * a[1], e[1] * a[0], e[0])};
}

}  // namespace

SceneCamera::SceneCamera(vtkCamera& camera) : camera_(camera) {
  camera_.SetViewAngle(units::to_deg(view_angle));
  apply();
}

void SceneCamera::apply() {
  const Axes axes = axes_of(azimuth_, elevation_);
  const double distance = perspective_ ? half_height_ / std::tan(view_angle / 2) : parallel_eye_distance;
  const Vec3 eye = focal_ + distance * axes.towards;
  camera_.SetParallelProjection(perspective_ ? 0 : 1);
  camera_.SetFocalPoint(focal_.x(), focal_.y(), focal_.z());
  camera_.SetPosition(eye.x(), eye.y(), eye.z());
  camera_.SetViewUp(axes.up.x(), axes.up.y(), axes.up.z());
  camera_.SetParallelScale(half_height_);
}

void SceneCamera::look(StandardView view) {
  const Angles angles = angles_of(view);
  azimuth_ = angles.azimuth;
  elevation_ = angles.elevation;
  focal_ = Vec3::Zero();
  fitted_ = true;
  apply();
}

void SceneCamera::fit(int width, int height, const ScreenRectangle& room,
                      const std::vector<ScreenRectangle>& covered,
                      const std::function<std::vector<Vec2>(const Projection&)>& outline) {
  // Labels do not grow with the path, and in perspective near parts grow faster the nearer the eye comes.
  // Moving half of the way each time converges. In the last rounds nothing grows, so that nothing is cut off.
  const int growing_rounds = perspective_ ? 16 : 6;
  const int rounds = growing_rounds + 12;
  constexpr double settled = 1e-3;
  focal_ = Vec3::Zero();
  apply();
  for (int round = 0; round < rounds; ++round) {
    const Projection before = projection(width, height);
    const std::vector<Vec2> hull = convex_hull(outline(before));
    const ScreenRectangle box = hull.empty() ? room : box_around(hull);
    const double extent = hull.size() < 2 ? 0 : box.size().maxCoeff() / before.scale;  // [scene units]
    // A line seen end on has no size: the scene's unit then fills the room.
    const double usual = room.size().minCoeff() / before.scale;
    const bool grows = round < growing_rounds;
    const double largest = !grows ? 1 : extent < min_half_height ? usual : HUGE_VAL;
    const FittedOutline fitted = fit_outline(hull, room, covered, largest);
    constexpr double largest_step = 1.5;
    constexpr double spare = 0.99;  // shrinking then ends sooner
    const double step = !grows && fitted.factor < 1 ? spare * fitted.factor
                        : perspective_              ? std::sqrt(fitted.factor)
                                                    : fitted.factor;
    const double factor = perspective_ ? std::clamp(step, 1 / largest_step, largest_step) : step;
    half_height_ = std::clamp(half_height_ / factor, min_half_height, largest_half_height);
    apply();
    const Projection view = projection(width, height);
    const Vec2 wanted = fitted.place + fitted.factor * box.centre();  // of its centre
    const Vec2 shift = wanted - view.middle - factor * (box.centre() - view.middle);
    focal_ -= (shift.x() * view.right + shift.y() * view.up) / view.scale;
    apply();
    if (std::abs(fitted.factor - 1) < settled && shift.norm() < 1) {
      break;
    }
  }
  fitted_ = true;
}

void SceneCamera::fit_part(int width, int height, const Bounds& box, const ScreenRectangle& room,
                           const std::vector<ScreenRectangle>& covered) {
  constexpr double air = 1.15;
  focal_ = (box.min + box.max) / 2;
  const Projection start = projection(width, height);
  const Vec3 size = box.max - box.min;
  const Vec2 half =
      air / 2 * start.scale * Vec2(size.dot(start.right.cwiseAbs()), size.dot(start.up.cwiseAbs()));
  const std::vector<Vec2> corners =
      convex_hull({start.middle - half, start.middle + half, start.middle + Vec2(half.x(), -half.y()),
                   start.middle + Vec2(-half.x(), half.y())});
  const FittedOutline fitted = fit_outline(corners, room, covered, half.isZero(0) ? 1 : HUGE_VAL);
  half_height_ = std::clamp(half_height_ / fitted.factor, min_half_height, largest_half_height);
  fitted_ = false;
  apply();
  pan(fitted.place + fitted.factor * start.middle - start.middle, width, height);
}

void SceneCamera::orbit(double azimuth, double elevation, const Vec3& pivot) {
  const Axes before = axes_of(azimuth_, elevation_);
  azimuth_ = std::remainder(azimuth_ + azimuth, 2 * units::pi);
  elevation_ = std::clamp(elevation_ + elevation, -quarter, quarter);
  const Axes after = axes_of(azimuth_, elevation_);
  const Vec3 arm = focal_ - pivot;
  focal_ = pivot + arm.dot(before.right) * after.right + arm.dot(before.up) * after.up +
           arm.dot(before.towards) * after.towards;
  fitted_ = false;
  apply();
}

void SceneCamera::pan(const Vec2& shift, int width, int height) {
  const Projection view = projection(width, height);
  focal_ -= (shift.x() * view.right + shift.y() * view.up) / view.scale;
  fitted_ = false;
  apply();
}

void SceneCamera::zoom_to_box(const ScreenRectangle& box, const ScreenRectangle& room, int width,
                              int height) {
  constexpr double smallest = 4;  // [pixels]
  const Vec2 size = (box.high - box.low).cwiseMax(smallest);
  const Vec2 centre = (room.low + room.high) / 2;
  pan(centre - (box.low + box.high) / 2, width, height);
  zoom((room.high - room.low).cwiseQuotient(size).minCoeff(), centre, width, height);
}

void SceneCamera::zoom(double factor, const Vec2& about, int width, int height) {
  const Projection view = projection(width, height);
  const double before = half_height_;
  half_height_ = std::clamp(half_height_ / factor, min_half_height, largest_half_height);
  const Vec2 arm = (about - view.middle) / view.scale * (1 - half_height_ / before);
  focal_ += arm.x() * view.right + arm.y() * view.up;
  fitted_ = false;
  apply();
}

void SceneCamera::set_perspective(bool perspective) {
  perspective_ = perspective;
  apply();
}

CameraState SceneCamera::state(const SceneFrame& frame) const {
  return {.focal = frame.centre + frame.unit * focal_,
          .azimuth = azimuth_,
          .elevation = elevation_,
          .height = 2 * half_height_ * frame.unit,
          .perspective = perspective_,
          .fitted = fitted_};
}

void SceneCamera::set_state(const CameraState& state, const SceneFrame& frame) {
  focal_ = frame.to_scene(state.focal);
  azimuth_ = state.azimuth;
  elevation_ = std::clamp(state.elevation, -quarter, quarter);
  half_height_ = std::clamp(state.height / frame.unit / 2, min_half_height, largest_half_height);
  perspective_ = state.perspective;
  fitted_ = state.fitted;
  apply();
}

void SceneCamera::set_clipping(double front, double behind) {
  // Depths have 24 bits: their resolution must not be coarser than the distances of layers.
  constexpr double deepest = 1000;  // times the height of the view
  if (!perspective_) {
    front = std::min(front, deepest * 2 * half_height_);
    behind = std::min(behind, deepest * 2 * half_height_);
  }
  const Projection view = projection(1, 1);
  const double eye = perspective_ ? view.eye_distance : parallel_eye_distance;
  const double to_centre = focal_.dot(view.towards) + eye;
  const double far = to_centre + scene_radius + behind;
  const double near = to_centre - scene_radius - front;
  constexpr double nearest = 0.02;  // of the eye's distance; nearer parts would block the view
  camera_.SetClippingRange(perspective_ ? std::max(near, nearest * eye) : near,
                           perspective_ ? std::max(far, 2 * nearest * eye) : far);
}

}  // namespace feedscope::ui
