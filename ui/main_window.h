#pragma once

#include <QMainWindow>
#include <filesystem>

#include "ui/charts/charts_panel.h"
#include "ui/models/lesson_desk.h"
#include "ui/models/workbench.h"
#include "ui/theme/theme.h"
#include "ui/views/annotations_view.h"
#include "ui/views/command_palette.h"
#include "ui/views/contour_view.h"
#include "ui/views/diagnostics_view.h"
#include "ui/views/lesson_view.h"
#include "ui/views/playback_bar.h"
#include "ui/views/program/program_panel.h"
#include "ui/views/run_notice.h"
#include "ui/views/runs_view.h"
#include "ui/views/scene_view.h"
#include "ui/views/setup_view.h"
#include "ui/views/side_by_side.h"
#include "ui/views/slow_places_view.h"
#include "ui/views/study_view.h"
#include "ui/views/why_view.h"
#include "ui/window_session.h"

namespace feedscope::ui {

class DockSizes;
class StartHint;

/// Program text, 3D view and charts of one run, locked together by one cursor, with the machine editor.
/// Wires models and views; holds no logic of its own.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// `model` outlives this.
  MainWindow(Workbench& model, RenderBackend backend, QWidget* parent = nullptr);

  Workbench& model() { return model_; }
  ProgramView& program() { return program_->view(); }
  ProgramPanel& program_panel() { return *program_; }
  SceneView& scene() { return *scene_; }
  SideBySide& scenes() { return *scenes_; }
  ChartsPanel& charts() { return *charts_; }
  SetupView& setup() { return *setup_; }
  PlaybackBar& playback() { return *playback_; }
  DiagnosticsView& diagnostics() { return *diagnostics_; }
  SlowPlacesView& slow_places() { return *slow_places_; }
  RunsView& runs() { return *runs_; }
  RunNotice& notice() { return *notice_; }
  StartHint& start_hint() { return *start_hint_; }
  WhyView& why() { return *why_; }
  AnnotationsView& annotations() { return *annotations_; }
  StudyView& study() { return *study_; }
  ContourView& contour() { return *contour_; }
  LessonView& lessons() { return *lessons_; }
  CommandPalette& palette() { return *palette_; }
  /// Whether a panel is still working at what it shows, the run itself apart.
  bool busy() const {
    return why_->busy() || study_->busy() || contour_->busy() || desk_.busy() || scenes_->comparison().busy();
  }
  /// Opens a lesson in its panel, and what it begins with in all others.
  void open_lesson(const std::filesystem::path& file);
  WindowSession& session() { return *session_; }
  /// A program or a session, by the end of its name; asks before what is not saved goes.
  void open(const std::filesystem::path& file);
  /// As QMainWindow::restoreState(), with sizes that hold when the window becomes smaller and larger again.
  void restore_layout(const QByteArray& layout);
  /// Every command of the menus, in their order.
  QList<ListedAction> commands() const;

 signals:
  /// Of what is under way.
  void cancel_wanted();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  /// Tabs of panels keep their whole names: Qt would cut them to "Why h…".
  void childEvent(QChildEvent* event) override;

 private:
  void make_docks();
  void make_menus();
  void make_file_menu();
  void make_view_menu();
  void make_language_menu(QMenu* view);
  void make_help_menu();
  /// The language of the window is chosen at its start.
  void offer_restart();
  QAction* add_action(QMenu* menu, const QString& text, const QKeySequence& key, const QString& tip);
  void list_recent_files(QMenu* menu);
  void set_theme(ThemeKind kind);
  /// `folder`: where the search begins.
  void ask_for_program(const QString& folder);
  void ask_for_sample();
  void ask_for_machine();
  void ask_how_to_read();
  void save_machine();
  void show_program();
  void show_title();
  void show_run();
  void show_cursor();
  /// Cursor and charts at a place that lasts from one time to another [s].
  void show_place(double time, double from, double to);
  void show_unfollowed();
  void show_other_runs();
  void show_run_name();
  void show_lesson(const LessonWindow& look);
  void raise_lessons();
  void show_failure(const QString& message);
  void loop_what_is_shown(bool on);
  /// From cursor A to cursor B of the charts, or all that they show [s].
  std::array<double, 2> chosen_times() const;
  /// In the charts, from one time to another [s].
  void show_times(double from, double to);
  QDockWidget* add_dock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);

  Workbench& model_;
  ProgramPanel* program_;
  SceneView* scene_;
  SideBySide* scenes_;
  ChartsPanel* charts_;
  SetupView* setup_;
  PlaybackBar* playback_;
  DiagnosticsView* diagnostics_;
  SlowPlacesView* slow_places_;
  RunsView* runs_;
  RunNotice* notice_;
  StartHint* start_hint_;
  WhyView* why_;
  AnnotationsView* annotations_;
  StudyView* study_;
  ContourView* contour_;
  LessonDesk desk_;
  LessonView* lessons_;
  WindowSession* session_;
  CommandPalette* palette_;
  KeyList* key_list_;
  QDockWidget* charts_dock_ = nullptr;
  QDockWidget* lesson_dock_ = nullptr;
  QDockWidget* diagnostics_dock_ = nullptr;
  QDockWidget* runs_dock_ = nullptr;
  DockSizes* dock_sizes_ = nullptr;
  QByteArray first_layout_;
  std::filesystem::path fitted_to_;  ///< program that the camera was last fitted to
};

}  // namespace feedscope::ui
