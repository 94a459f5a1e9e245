#pragma once

#include <QObject>
#include <vector>

#include "ui/scene_view/scene_view.h"
#include "ui/workbench/workbench.h"

class QAction;

namespace feedscope::ui {

/// Makes the camera follow the cursor: to a place chosen in another panel, and in playback after a cursor
/// that leaves the view. The view before a jump can be restored.
class CameraTrail : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this.
  CameraTrail(Workbench& workbench, SceneView& scene, QObject* parent);

  QAction* back() const { return back_; }

 public slots:
  /// Moves the cursor into view.
  void follow_cursor();

 private:
  void go_to(double from, double to);
  void keep();
  void go_back();

  Workbench& workbench_;
  SceneView& scene_;
  QAction* back_;
  std::vector<CameraState> before_;  ///< the latest last
};

}  // namespace feedscope::ui
