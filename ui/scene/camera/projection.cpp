#include "ui/scene/camera/projection.h"

#include <vtkCamera.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace feedscope::ui {

SceneFrame frame_around(const Bounds& content) {
  constexpr double air = 0.03;
  constexpr double default_extent = 100;  // [mm]
  SceneFrame frame;
  Bounds box = content;
  if (box.empty()) {
    box.add(Vec3::Zero());
  }
  double extent = (box.max - box.min).maxCoeff();
  frame.centre = (box.min + box.max) / 2;
  // An extent in the last digits of a double cannot be distinguished from a point.
  if (extent <= 1e-12 * (1 + frame.centre.cwiseAbs().maxCoeff())) {
    extent = default_extent;
    box.min -= Vec3(extent / 2, extent / 2, 0);
    box.max += Vec3(extent / 2, extent / 2, 0);
  }
  frame.unit = extent;
  for (int axis = 0; axis < 3; ++axis) {
    double half = (box.max[axis] - box.min[axis]) / 2 / extent;
    half = half < 1e-7 ? 0.0 : half + std::min(air, half);
    frame.box.add(axis, -half);
    frame.box.add(axis, half);
  }
  return frame;
}

Projection::Projection(vtkCamera& camera, int width, int height) : middle(width / 2.0, height / 2.0) {
  focal = Vec3(camera.GetFocalPoint());
  const Vec3 to_eye = Vec3(camera.GetPosition()) - focal;
  towards = to_eye.normalized();
  right = Vec3(camera.GetViewUp()).cross(towards).normalized();
  up = towards.cross(right);
  scale = height / 2.0 / camera.GetParallelScale();
  eye_distance = camera.GetParallelProjection() != 0 ? 0.0 : to_eye.norm();
}

double Projection::magnification(const Vec3& p) const {
  constexpr double nearest = 0.02;  // of the eye's distance
  return perspective() ? 1 / std::max(nearest, 1 - (p - focal).dot(towards) / eye_distance) : 1.0;
}

Vec3 Projection::towards_eye(const Vec3& p) const {
  return perspective() ? Vec3((focal + eye_distance * towards - p).normalized()) : towards;
}

Projection::Lift Projection::lift(double height) const {
  if (!perspective()) {
    return {height * towards, 1};
  }
  const double share = height / eye_distance;
  return {share * (focal + eye_distance * towards), 1 - share};
}

}  // namespace feedscope::ui
