#pragma once

#include <QAction>
#include <QList>
#include <QPointF>
#include <QTimer>
#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "ui/scene/path_scene.h"
#include "ui/scene/render_window.h"
#include "ui/scene/scene_state.h"

class QMenu;
class QMouseEvent;
class QWheelEvent;

namespace feedscope::ui {

class AnnotationOverlay;
class SceneActions;

/// Software where Qt draws off screen (QT_QPA_PLATFORM offscreen or minimal), gpu elsewhere.
/// Needs a QGuiApplication.
RenderBackend default_backend();

/// Widget around a PathScene, with a bar of its commands. Left drag turns about what is under the mouse,
/// middle or Shift drag moves, wheel or right drag zooms, Ctrl drag draws a box to zoom to; a click on the
/// executed path picks a time, one on the cube's faces a view, a double click fits. The mouse held over the
/// path tells line, feed, cause and deviation. All views of a process must have the same backend.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  /// Throws what make_render_window() throws.
  explicit SceneView(RenderBackend backend = default_backend(), QWidget* parent = nullptr);
  ~SceneView() override;

  /// Whatever changes the scene, the view's commands follow.
  PathScene& scene() { return scene_; }
  SceneState state() const { return scene_state(scene_); }
  void set_state(const SceneState& state) { set_scene_state(scene_, state); }
  /// The widget that shows the scene and takes the mouse.
  QWidget& canvas() { return *canvas_; }
  /// How much larger than usual text and lines are, by the font; the pixels of the screen count besides.
  double text_scale() const;
  AnnotationOverlay& annotations() { return *overlay_; }
  QSize sizeHint() const override { return {800, 600}; }
  /// Every command of the view: for menus, key lists and the command palette.
  QList<QAction*> panel_actions() const;
  /// Adds them to a menu, those that belong together as submenus.
  void fill_menu(QMenu& menu) const;
  /// The commands stay, with or without their bar.
  void show_bar(bool shown);
  int bar_height() const;
  void set_bar_height(int height);
  /// Beside another view, which this one is linked to: two commands with one key would be ambiguous and none
  /// of them called, so the keys are those of the other view, here too. The bar keeps what acts on this view
  /// alone.
  void take_commands_of(const SceneView& other);
  /// Puts a widget before the commands of the bar, which owns it with the action that is returned.
  QAction* add_to_bar(QWidget& widget);
  /// Whether there is another run to compare with, and the menu that says which.
  void set_comparable(bool comparable);
  void add_comparison_menu(QMenu& menu);
  /// More lines for what the mouse tells of a time of the executed path.
  void set_hover_more(std::function<QString(double time)> more) { hover_more_ = std::move(more); }
  /// More for the context menu, which opens where the pointer is on the path: picked() comes first.
  void set_place_actions(const QList<QAction*>& actions) { place_actions_ = actions; }

 public slots:
  /// The charts show from `from` to `to` [s]; marked on the path unless that is all of the run.
  void show_times(double from, double to);
  /// The path between two times fills the view [s].
  void zoom_to_times(double from, double to);
  /// Frames without every detail until some time after the last move or other change.
  void begin_rest();
  /// Every detail from the next frame on.
  void rest();
  /// Two clicks on the path measure from one place to the other; false ends and clears.
  void set_measuring(bool measuring);
  /// The next drag draws a box to zoom to.
  void set_boxing(bool boxing);
  /// Emits times_chosen() for what is in view.
  void choose_visible_times();

 signals:
  /// A new frame is needed: camera, colours, path.
  void changed();
  /// A click, not a drag, on the executed path; `time` [s].
  void picked(double time);
  /// The charts are to show this range [s].
  void times_chosen(double from, double to);
  void measuring_changed(bool measuring);
  void boxing_changed(bool boxing);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  enum class Drag { none, orbit, pan, zoom, box };

  void make_canvas(RenderBackend backend);
  void follow_scene();
  void press(const QMouseEvent& mouse);
  void drag(const QMouseEvent& mouse);
  void release(const QMouseEvent& mouse);
  void wheel(const QWheelEvent& event);
  bool key(int key);
  void click(const QPointF& place);
  void add_measured(double time);
  void finish_box(const QPointF& corner);
  void show_menu(const QMouseEvent& mouse);
  void hover();
  void leave();
  void follow_text_size();
  void follow_palette();
  Pixel pixel(const QPointF& place) const;

  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  PathScene scene_;
  QWidget* canvas_ = nullptr;
  AnnotationOverlay* overlay_ = nullptr;
  SceneActions* actions_ = nullptr;
  QList<QAction*> place_actions_;
  std::function<QString(double)> hover_more_;
  QTimer hover_timer_;
  QTimer rest_timer_;
  Drag drag_ = Drag::none;
  bool dragged_ = false;
  bool measuring_ = false;
  bool axes_before_ = false;  ///< measuring, which shows them
  bool boxing_ = false;
  std::optional<double> measured_from_;  ///< first place clicked [s]
  std::optional<Vec3> pivot_;            ///< of the drag under way
  QPointF pressed_;
  QPointF last_;
};

}  // namespace feedscope::ui
