#pragma once

#include <QMainWindow>
#include <QTimer>
#include <array>
#include <filesystem>
#include <optional>

#include "ui/circular/circular_job.h"
#include "ui/lessons/lesson_desk.h"
#include "ui/scene_view/side_by_side.h"
#include "ui/window/panel_states.h"
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

/// The 3D view with the panels around it and their commands in menus. Panels follow the workbench by
/// themselves: this docks them, and passes on what one asks of another.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  MainWindow(Workbench& workbench, RenderBackend backend, QWidget* parent = nullptr);

  Workbench& workbench() { return workbench_; }
  WindowSession& session() { return *session_; }
  SideBySide& scenes() { return *scenes_; }
  SceneView& scene() { return scenes_->first(); }
  /// The one part of the window that is a Part: a panel, the bar that plays ...
  template <class Part>
  Part& part() const {
    return *findChild<Part*>();
  }
  /// Whether a panel is still working at what it shows, the run itself apart.
  bool busy() const;
  /// Opens a lesson in its panel, and what it begins with in all others.
  void open_lesson(const std::filesystem::path& file);
  /// A program, a session or a machine file by the end of its name, the configuration of a control and a
  /// trace by their content; asks before what is not saved goes.
  void open(const std::filesystem::path& file);
  /// A machine file, or the configuration of a control.
  void open_machine(const std::filesystem::path& file);
  Presentation& presentation() const { return *presentation_; }
  /// Where the panels stand, to be kept: with_checksum() of Presentation::usual_layout().
  QByteArray layout_to_keep() const;
  /// As QMainWindow::restoreState() of what was kept, ending a presentation, with sizes that hold when the
  /// window becomes smaller and larger again; once the window is shown, if it is not. The default layout in
  /// place of one that cannot be read or lacks a panel.
  void restore_layout(const QByteArray& layout);
  /// What the window shows, to be shown again by another window on the same workbench, in another language or
  /// other units.
  struct Handover {
    QByteArray geometry;
    WindowSession::Kept session;
    PanelStates panels;
    std::filesystem::path lesson;  ///< open; empty: none
    std::size_t question = 0;
    std::optional<CircularShown> circular;
  };
  Handover hand_over();
  void take_over(const Handover& before);

 signals:
  /// Of what is under way.
  void cancel_wanted();
  /// The language or the units have been chosen: the window is to be made again.
  void remake_wanted();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Tabs of panels keep their whole names: Qt would cut them to "Why h…".
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
  /// From cursor A to cursor B of the charts, or all that they show [s].
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
  QTimer settling_;           ///< runs while a window that has just been shown gets its size
};

}  // namespace feedscope::ui
