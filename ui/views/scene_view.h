#pragma once

#include <QPointF>
#include <QWidget>
#include <memory>

#include "ui/scene/path_scene.h"
#include "ui/scene/render_window.h"

namespace feedscope::ui {

/// Software where Qt draws off screen (QT_QPA_PLATFORM offscreen or minimal), gpu elsewhere.
/// Needs a QGuiApplication.
RenderBackend default_backend();

/// Widget around a PathScene: left drag turns, middle or Shift drag moves, wheel or right drag zooms, a click
/// on the executed path picks a time. All views of a process must have the same backend.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  /// Throws what make_render_window() throws.
  explicit SceneView(RenderBackend backend = default_backend(), QWidget* parent = nullptr);
  ~SceneView() override;

  PathScene& scene() { return scene_; }
  /// The widget that shows the scene and takes the mouse.
  QWidget& canvas() { return *canvas_; }
  QSize sizeHint() const override { return {800, 600}; }

 signals:
  /// A click, not a drag, on the executed path; `time` [s].
  void picked(double time);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  struct Vtk;
  void click(const QPointF& place);
  void follow_text_size();

  std::unique_ptr<Vtk> vtk_;
  PathScene scene_;
  QWidget* canvas_;
  QPointF pressed_;
};

}  // namespace feedscope::ui
