#include "ui/scene/scene_camera.h"

#include <vtkCamera.h>

#include <algorithm>

namespace feedscope::ui {
namespace {

constexpr double eye_distance = 40;  // scene units; a parallel projection shows the same from anywhere
constexpr double scene_radius = 1.5;

struct Direction {
  Vec3 towards, up;
};

Direction direction_of(StandardView view) {
  switch (view) {
    case StandardView::top:
      return {Vec3::UnitZ(), Vec3::UnitY()};
    case StandardView::front:
      return {-Vec3::UnitY(), Vec3::UnitZ()};
    case StandardView::right:
      return {Vec3::UnitX(), Vec3::UnitZ()};
    case StandardView::iso:
      break;
  }
  return {Vec3(1, -1, 1).normalized(), Vec3::UnitZ()};
}

}  // namespace

SceneCamera::SceneCamera(vtkCamera& camera) : camera_(camera) {
  camera_.ParallelProjectionOn();
}

SceneCamera::Pose SceneCamera::pose() const {
  return {Vec3(camera_.GetFocalPoint()), Vec3(camera_.GetPosition()), Vec3(camera_.GetViewUp()),
          camera_.GetParallelScale()};
}

bool SceneCamera::fitted() const {
  return fitted_ && *fitted_ == pose();
}

void SceneCamera::place(const Vec3& focal, const Vec3& towards) {
  const Vec3 eye = focal + eye_distance * towards;
  camera_.SetFocalPoint(focal.x(), focal.y(), focal.z());
  camera_.SetPosition(eye.x(), eye.y(), eye.z());
}

void SceneCamera::look(StandardView view) {
  const Direction direction = direction_of(view);
  camera_.SetViewUp(direction.up.x(), direction.up.y(), direction.up.z());
  place(Vec3::Zero(), direction.towards);
  camera_.OrthogonalizeViewUp();
  fitted_ = pose();
}

void SceneCamera::fit(int width, int height, const Bounds& box, const ScreenRectangle& room,
                      const std::function<ScreenRectangle(const Projection&)>& extent) {
  place(Vec3::Zero(), projection(width, height).towards);
  const Projection start = projection(width, height);
  const Vec3 size = box.max - box.min;
  const Vec2 content(size.dot(start.right.cwiseAbs()), size.dot(start.up.cwiseAbs()));
  const Vec2 space = (room.high - room.low).cwiseMax(16);
  // Labels do not grow with the path, so their room is known only once they are laid out: a few rounds
  // settle.
  Vec2 labels = space / 8;
  Vec2 shift = Vec2::Zero();
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    const Vec2 free = (space - labels).cwiseMax(space / 4);
    // What is seen end on has no size: the scene's unit then takes the room.
    const double pixels = content.isZero() ? free.minCoeff() : free.cwiseQuotient(content).minCoeff();
    camera_.SetParallelScale(height / 2.0 / pixels);
    const ScreenRectangle covered = extent(projection(width, height));
    labels = covered.high - covered.low - pixels * content;
    shift = (covered.low + covered.high - room.low - room.high) / 2;
  }
  const Projection view = projection(width, height);
  place((shift.x() * view.right + shift.y() * view.up) / view.scale, view.towards);
  fitted_ = pose();
}

void SceneCamera::set_clipping(double front) {
  const Pose now = pose();
  const Vec3 towards = (now.position - now.focal).normalized();
  const double to_centre = now.position.dot(towards);
  camera_.SetClippingRange(to_centre - scene_radius - front, to_centre + scene_radius);
}

}  // namespace feedscope::ui
