#pragma once

#include <QMainWindow>
#include <QTimer>
#include <array>
#include <filesystem>
#include <optional>

#include "ui/circular/circular_job.h"
#include "ui/lessons/lesson_desk.h"
#include "ui/scene_view/side_by_side.h"
#include "ui/window/panels/panel_states.h"
#include "ui/window/window_session.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

class AnnotationsView;
class ChartsPanel;
class CircularView;
class LoadView;
class ContourView;
class DecideView;
class DiagnosticsView;
class DockSizes;
class FileMenu;
class HandoutCommand;
class HelpMenu;
class IdentificationView;
class LessonView;
class MachineOpening;
class PlaybackBar;
class Presentation;
class ProgramPanel;
class RunsView;
class SetupView;
class SlowPlacesView;
class StartPage;
class StudyView;
class TimeView;
class TraceView;
class VersionsView;
class WhyView;

/// The 3D view with the panels around it and their commands in menus. Panels follow the workbench themselves:
/// this docks them, and passes requests from one to another.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  MainWindow(Workbench& workbench, RenderBackend backend, QWidget* parent = nullptr);

  Workbench& workbench() { return workbench_; }
  WindowSession& session() { return *session_; }
  SideBySide& scenes() { return *scenes_; }
  SceneView& scene() { return scenes_->first(); }
  /// The only part of the window of type Part: a panel, the playback bar ...
  template <class Part>
  Part& part() const {
    return *findChild<Part*>();
  }
  /// Whether a panel is still computing its contents, apart from the run itself.
  bool busy() const;
  /// Opens a lesson in its panel, and its initial contents in all others.
  void open_lesson(const std::filesystem::path& file);
  /// Opens a program, a session or a machine file by its ending, a control's configuration and a trace by
  /// their contents; asks before discarding unsaved work.
  void open(const std::filesystem::path& file);
  /// Opens a machine file, or the configuration of a control.
  void open_machine(const std::filesystem::path& file);
  Presentation& presentation() const { return *presentation_; }
  /// Layout of the panels, for saving: with_checksum() of Presentation::usual_layout().
  QByteArray layout_to_keep() const;
  /// QMainWindow::restoreState() of a saved layout, which ends a presentation, with sizes that survive when
  /// the window is made smaller and larger again; if the window is not shown yet, when it is. Uses the
  /// default layout instead of one that is invalid or lacks a panel.
  void restore_layout(const QByteArray& layout);
  /// State of the window, for another window on the same workbench, in another language or other units.
  struct Handover {
    QByteArray geometry;
    WindowSession::Kept session;
    PanelStates panels;
    std::filesystem::path lesson;  ///< the open one; empty: none
    std::size_t question = 0;
    std::optional<CircularShown> circular;
  };
  Handover hand_over();
  void take_over(const Handover& before);

 signals:
  /// Requests to cancel the running work.
  void cancel_wanted();
  /// The user has chosen a language or units: the window must be rebuilt.
  void remake_wanted();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Keeps the whole names on the tabs of panels: Qt would shorten them to "Why h…".
  void childEvent(QChildEvent* event) override;

 private:
  void make_centre();
  void make_docks();
  void add_dock(Panel& panel);
  static void show_title_bar(QDockWidget& dock, bool shown);
  static QDockWidget& dock_of(const Panel& panel);
  void make_menus();
  void make_status();
  void connect_panels();
  void connect_lessons();
  void connect_start_page();
  void place_start_page();
  void apply_layout();
  void show_program();
  void show_title();
  void show_lesson(const LessonWindow& look);
  void show_failure(const QString& message);
  /// From cursor A to cursor B of the charts, or their whole range [s].
  std::optional<std::array<double, 2>> chosen_times() const;

  Workbench& workbench_;
  SideBySide* scenes_;
  PlaybackBar* playback_;
  ProgramPanel* program_;
  SetupView* setup_;
  DecideView* decide_;
  TimeView* time_;
  WhyView* why_;
  AnnotationsView* annotations_;
  LessonDesk desk_;
  LessonView* lessons_;
  ChartsPanel* charts_;
  RunsView* runs_;
  SlowPlacesView* slow_places_;
  DiagnosticsView* diagnostics_;
  StudyView* study_;
  ContourView* contour_;
  CircularView* circular_;
  LoadView* load_;
  TraceView* traces_;
  VersionsView* versions_;
  IdentificationView* identification_;
  std::array<Panel*, 18> panels_;  ///< in the order of their tabs
  WindowSession* session_;
  MachineOpening* machines_;
  StartPage* start_page_;
  HandoutCommand* handouts_ = nullptr;
  FileMenu* file_menu_ = nullptr;
  DockSizes* dock_sizes_ = nullptr;
  Presentation* presentation_ = nullptr;
  QByteArray first_layout_;
  QByteArray wanted_layout_;  ///< to be restored once the window has its size; empty: none
  QTimer settling_;           ///< runs while a new window gets its size
};

}  // namespace feedscope::ui
