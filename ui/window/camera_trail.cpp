#include "ui/window/camera_trail.h"

#include <QAction>
#include <algorithm>

#include "ui/shared/panel_action.h"

namespace feedscope::ui {

namespace {

constexpr double least_beside = 0.2;  // before and after a place [s]
constexpr std::size_t most_kept = 50;
constexpr double edge = 0.05;  // of the view, where a place is hardly visible

}  // namespace

CameraTrail::CameraTrail(Workbench& workbench, SceneView& scene, QObject* parent)
    : QObject(parent), workbench_(workbench), scene_(scene) {
  back_ = make_action(this, tr("View &before"), tr("The 3D view as it was before the last jump to a place"),
                      QKeySequence(tr("Alt+Left")), &CameraTrail::go_back);
  back_->setEnabled(false);
  connect(&workbench_, &Workbench::place_shown, this, &CameraTrail::go_to);
  connect(&workbench_.cursor(), &Cursor::changed, this, [this] {
    if (workbench_.playback().playing()) {
      follow_cursor();
    }
  });
  connect(&workbench_, &Workbench::program_changed, this, [this] {
    before_.clear();
    back_->setEnabled(false);
  });
}

void CameraTrail::keep() {
  const CameraState now = scene_.scene().camera();
  if (before_.empty() || before_.back() != now) {
    before_.push_back(now);
  }
  if (before_.size() > most_kept) {
    before_.erase(before_.begin());
  }
  back_->setEnabled(true);
}

void CameraTrail::go_to(double from, double to) {
  keep();
  const double beside = std::max(to - from, least_beside);
  scene_.zoom_to_times(from - beside, to + beside);
}

void CameraTrail::follow_cursor() {
  const Cursor& cursor = workbench_.cursor();
  PathScene& scene = scene_.scene();
  if (!cursor.valid() || scene.trajectory() != cursor.trajectory()) {
    return;
  }
  const Pixel at = scene.pixel_of(scene.drawn_at(cursor.state().time));
  const double ratio = scene_.canvas().devicePixelRatioF();
  const Pixel size{scene_.canvas().width() * ratio, scene_.canvas().height() * ratio};
  const auto is_seen = [&](std::size_t i) {
    return at[i] >= edge * size[i] && at[i] <= (1 - edge) * size[i];
  };
  if (is_seen(0) && is_seen(1)) {
    return;
  }
  if (!workbench_.playback().playing()) {
    keep();
  }
  scene.pan({size[0] / 2 - at[0], size[1] / 2 - at[1]});
}

void CameraTrail::go_back() {
  if (!before_.empty()) {
    scene_.scene().set_camera(before_.back());
    before_.pop_back();
    back_->setEnabled(!before_.empty());
  }
}

}  // namespace feedscope::ui
