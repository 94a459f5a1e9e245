#pragma once

#include <QList>
#include <QWidget>
#include <filesystem>
#include <memory>

#include "ui/scene_view/scene_run.h"
#include "ui/scene_view/scenes_state.h"
#include "ui/workbench/workbench.h"

class QComboBox;
class QLabel;
class QMenu;
class QSplitter;

namespace feedscope::ui {

class LensOverlay;
class SplitOverlay;

/// The 3D view of the current run and, if wanted, that of another one: beside it, or over the right part of
/// it behind a line that is dragged. Both are turned, coloured and enlarged in the same way, the tool of both
/// at the same place of the program; colours may say how one differs from the other.
class SideBySide : public QWidget {
  Q_OBJECT

 public:
  /// `first` shows the current run and becomes a part of this. `workbench` outlives this.
  SideBySide(Workbench& workbench, SceneView& first, RenderBackend backend, QWidget* parent = nullptr);
  ~SideBySide() override;

  void set_mode(ScenesMode mode);
  ScenesMode mode() const { return mode_; }
  ScenesState state() const;
  void set_state(const ScenesState& state);
  /// The view of the current run.
  SceneView& first() { return first_; }
  /// SceneView::rest() of all views.
  void rest();
  /// Null while there is one view alone.
  SceneView* second() { return second_; }
  /// Null unless the view is split.
  SplitOverlay* split() { return split_.get(); }
  /// In the view of the current run.
  LensOverlay& lens() { return *lens_; }
  /// Which run stands beside the current one.
  QComboBox* choice() { return choice_; }
  RunComparison& comparison() { return comparison_; }
  QList<QAction*> panel_actions() const { return actions_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow_workbench();
  /// The program is another one.
  void show_program();
  /// The current run or its result is another one.
  void show_current();
  void show_run_name();
  /// The other runs, as lines in the view of the current one.
  void show_overlays();
  void make_actions();
  QAction* add_mode(ScenesMode mode, const QString& text, const QString& tip, const QKeySequence& key);
  void make_comparison_menu();
  void list_references();
  void open();
  void close();
  void make_choice(QWidget* parent);
  void list_runs();
  void show_run();
  void show_cursor();
  void show_names();
  void share_colour_scale();
  void link(SceneView& from);
  void follow_first();

  Workbench& workbench_;
  SceneView& first_;
  RenderBackend backend_;
  RunComparison comparison_;
  SceneRun first_run_;
  QSplitter* splitter_;
  QMenu* references_;
  LensOverlay* lens_;
  QList<QAction*> actions_;
  QAction* beside_ = nullptr;
  QAction* across_ = nullptr;
  ScenesMode mode_ = ScenesMode::one;
  double share_ = 0.5;
  SceneView* second_ = nullptr;
  std::unique_ptr<SceneRun> second_run_;
  QComboBox* choice_ = nullptr;
  QLabel* first_name_ = nullptr;  ///< on the bar of the first of two views
  QAction* named_ = nullptr;
  std::unique_ptr<SplitOverlay> split_;
  int other_ = 0;  ///< id of the run that was chosen to stand beside; 0: the first other one
  bool linking_ = false;
  std::filesystem::path fitted_to_;  ///< program that the camera was last fitted to
};

}  // namespace feedscope::ui
