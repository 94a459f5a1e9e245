#include "ui/window/main_window.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QPainter>
#include <QStatusBar>
#include <QStyle>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "core/analysis/notes/not_counted.h"
#include "core/identification/recordings.h"
#include "ui/annotations/annotation_overlay.h"
#include "ui/annotations/annotations_view.h"
#include "ui/charts/charts_panel.h"
#include "ui/circular/circular_view.h"
#include "ui/contour/contour_view.h"
#include "ui/decide/decide_view.h"
#include "ui/identification/identification_view.h"
#include "ui/language/in_language.h"
#include "ui/language/language.h"
#include "ui/lessons/lesson_view.h"
#include "ui/load/load_view.h"
#include "ui/messages/diagnostics_view.h"
#include "ui/playback/playback_bar.h"
#include "ui/program_text/program_panel.h"
#include "ui/runs/run_notice.h"
#include "ui/runs/runs_view.h"
#include "ui/setup/setup_bar.h"
#include "ui/setup/setup_view.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/slow_places/slow_places_view.h"
#include "ui/study/study_view.h"
#include "ui/theme/icons.h"
#include "ui/time_use/time_view.h"
#include "ui/trace/trace_view.h"
#include "ui/versions/versions_view.h"
#include "ui/why/why_view.h"
#include "ui/window/camera_trail.h"
#include "ui/window/menus/file_menu.h"
#include "ui/window/menus/handout_command.h"
#include "ui/window/menus/help_menu.h"
#include "ui/window/menus/lesson_menu.h"
#include "ui/window/menus/machine_opening.h"
#include "ui/window/menus/presentation.h"
#include "ui/window/menus/view_menu.h"
#include "ui/window/panels/dock_sizes.h"
#include "ui/window/panels/panel_scroll.h"
#include "ui/window/panels/saved_layout.h"
#include "ui/window/panels/start_page.h"
#include "ui/window/panels/status_panel.h"

namespace feedscope::ui {

namespace {

constexpr QSize default_size(1280, 800);
constexpr int program_width = 208;
constexpr int inspector_width = 292;
constexpr int charts_height = 189;

/// A note that ends in "…" where the bar has no room for it; its tip has all of it.
class StatusNote : public QLabel {
 public:
  using QLabel::QLabel;

  QSize minimumSizeHint() const override { return {1, QLabel::minimumSizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const QRect room = contentsRect();
    style()->drawItemText(&painter, room, Qt::AlignVCenter | Qt::AlignLeft, palette(), isEnabled(),
                          fontMetrics().elidedText(text(), Qt::ElideRight, room.width()), foregroundRole());
  }
};

}  // namespace

MainWindow::MainWindow(Workbench& workbench, RenderBackend backend, QWidget* parent)
    : QMainWindow(parent),
      workbench_(workbench),
      scenes_(new SideBySide(workbench, *new SceneView(backend, this), backend, this)),
      playback_(new PlaybackBar(workbench, this)),
      program_(new ProgramPanel(this)),
      setup_(new SetupView(workbench.setup(), this)),
      decide_(new DecideView(workbench, this)),
      time_(new TimeView(workbench.time_findings(), this)),
      why_(new WhyView(workbench.cursor(), this)),
      annotations_(new AnnotationsView(workbench.annotations(), workbench.cursor(), this)),
      desk_(workbench, chosen_language().toStdString()),
      lessons_(new LessonView(desk_, this)),
      charts_(new ChartsPanel(workbench.cursor(), workbench.view_range(), this)),
      runs_(new RunsView(workbench.runs(), this)),
      slow_places_(new SlowPlacesView(this)),
      diagnostics_(new DiagnosticsView(this)),
      study_(new StudyView(workbench, this)),
      contour_(new ContourView(workbench, this)),
      circular_(new CircularView(workbench, this)),
      load_(new LoadView(workbench, this)),
      traces_(new TraceView(workbench, this)),
      versions_(new VersionsView(this)),
      identification_(new IdentificationView(workbench, this)),
      panels_{program_, decide_,   time_, why_,         setup_,       annotations_,
              lessons_, charts_,   runs_, slow_places_, diagnostics_, study_,
              contour_, circular_, load_, traces_,      versions_,    identification_},
      session_(new WindowSession(*this, workbench)),
      machines_(new MachineOpening(workbench, *this)),
      start_page_(new StartPage(workbench, desk_, this)) {
  setWindowTitle(tr("Feedscope"));
  resize(default_size);
  setAcceptDrops(true);
  make_centre();
  make_docks();
  dock_sizes_ = new DockSizes(*this, program_width, inspector_width, charts_height);
  presentation_ = new Presentation(*this, *dock_sizes_,
                                   {dock_of(*lessons_), dock_of(*charts_), scene(), program_->view()});
  make_menus();
  first_layout_ = saveState();
  constexpr int settled_after = 500;  // [ms]
  settling_.setSingleShot(true);
  settling_.setInterval(settled_after);
  connect(&settling_, &QTimer::timeout, this, [this] { wanted_layout_.clear(); });
  make_status();
  connect_panels();
  connect_lessons();
  connect_start_page();
  connect(&workbench_, &Workbench::program_changed, this, &MainWindow::show_program);
  connect(&workbench_, &Workbench::failed, this, &MainWindow::show_failure);
  connect(session_, &WindowSession::file_changed, this, &MainWindow::show_title);
  connect(session_, &WindowSession::failed, this, &MainWindow::show_failure);
  connect(machines_, &MachineOpening::failed, this, &MainWindow::show_failure);
  connect(machines_, &MachineOpening::noted, diagnostics_, &DiagnosticsView::add_message);
  connect(traces_, &TraceView::noted, diagnostics_, &DiagnosticsView::add_message);
  connect(session_, &WindowSession::noticed, this,
          [this](const QString& message) { diagnostics_->add_message(Severity::info, message); });
  for (Panel* panel : panels_) {
    panel->follow(workbench_);
  }
  show_program();
}

bool MainWindow::busy() const {
  return std::ranges::any_of(panels_, [](const Panel* panel) { return panel->busy(); }) || desk_.busy() ||
         scenes_->comparison().busy();
}

void MainWindow::make_centre() {
  auto* centre = new QWidget(this);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(scenes_, 1);
  auto* notice = new RunNotice(workbench_, *scenes_);
  connect(&desk_, &LessonDesk::cover_changed, notice, [this, notice] {
    const bool covered = desk_.awaits_prediction();
    notice->say_without_program(covered ? tr("The run is shown once a prediction is written in the lesson.")
                                        : QString());
    program_->view().say_without_program(
        covered ? tr("The program is shown with the run, after the prediction.") : QString());
  });
  layout->addWidget(playback_);
  setCentralWidget(centre);
}

void MainWindow::make_docks() {
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  for (Panel* panel : panels_) {
    add_dock(*panel);
  }
  dock_of(*decide_).raise();
  dock_of(*charts_).raise();
  resizeDocks({&dock_of(*program_), &dock_of(*decide_)}, {program_width, inspector_width}, Qt::Horizontal);
  resizeDocks({&dock_of(*charts_)}, {charts_height}, Qt::Vertical);
}

/// Adds the panel as a tab of the first one in its area.
void MainWindow::add_dock(Panel& panel) {
  const Panel::Place& place = panel.place();
  auto* dock = new QDockWidget(place.title, this);
  dock->setObjectName(place.id);
  const bool scrolls =
      place.area == Qt::BottomDockWidgetArea && &panel != charts_;  // these scroll themselves
  dock->setWidget(scrolls ? static_cast<QWidget*>(new PanelScroll(panel, dock)) : &panel);
  addDockWidget(place.area, dock);
  const auto first = std::ranges::find(panels_, place.area, [](Panel* p) { return p->place().area; });
  if (*first != &panel) {
    tabifyDockWidget(&dock_of(**first), dock);
  }
  dock->setVisible(place.open);
  show_title_bar(*dock, false);
  connect(dock, &QDockWidget::topLevelChanged, this,
          [this, dock](bool floating) { show_title_bar(*dock, floating); });
  connect(dock, &QDockWidget::visibilityChanged, &panel, &Panel::set_on_screen);
  connect(&panel, &Panel::attention_wanted, dock, [dock] {
    dock->show();
    dock->raise();
  });
  connect(&panel, &Panel::failed, this, &MainWindow::show_failure);
}

/// Inside the window, a tab names the panel, or it needs no name.
void MainWindow::show_title_bar(QDockWidget& dock, bool shown) {
  delete dock.titleBarWidget();
  dock.setTitleBarWidget(shown ? nullptr : new QWidget(&dock));
}

QDockWidget& MainWindow::dock_of(const Panel& panel) {
  QWidget* around = panel.parentWidget();
  while (qobject_cast<QDockWidget*>(around) == nullptr) {
    around = around->parentWidget();
  }
  return *static_cast<QDockWidget*>(around);
}

void MainWindow::make_menus() {
  file_menu_ = new FileMenu(workbench_, *session_, *this);
  menuBar()->addMenu(file_menu_);

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QUndoStack& history = workbench_.setup().history();
  QAction* undo = history.createUndoAction(this, tr("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setToolTip(tr("Undo the last change of runs and settings"));
  undo->setIcon(edit_icon(EditIcon::undo));
  QAction* redo = history.createRedoAction(this, tr("Redo"));
  redo->setShortcut(QKeySequence::Redo);
  redo->setToolTip(tr("Redo the change that was undone"));
  redo->setIcon(edit_icon(EditIcon::redo));
  edit->addActions({undo, redo});
  edit->addSeparator();
  edit->addActions(program_->panel_actions());

  QMenu* runs = menuBar()->addMenu(tr("&Runs"));
  runs->addActions(decide_->panel_actions() + runs_->panel_actions() + QList<QAction*>{setup_->for_all()});
  runs->addSeparator();
  runs->addAction(make_action(this, tr("&Cancel simulation"),
                              tr("Stop reading, simulating or comparing runs"), Qt::Key_Escape,
                              &MainWindow::cancel_wanted));
  QMenu* analysis = menuBar()->addMenu(tr("A&nalysis"));
  for (const Panel* panel :
       {static_cast<Panel*>(study_), static_cast<Panel*>(contour_), static_cast<Panel*>(circular_),
        static_cast<Panel*>(load_), static_cast<Panel*>(traces_), static_cast<Panel*>(identification_),
        static_cast<Panel*>(versions_)}) {
    const QList<QAction*> actions = panel->panel_actions();
    actions.size() > 1 ? analysis->addMenu(dock_of(*panel).windowTitle())->addActions(actions)
                       : analysis->addActions(actions);
  }

  menuBar()->addMenu(tr("&Charts"))->addActions(charts_->panel_actions());
  QMenu* why = menuBar()->addMenu(tr("&Why here?"));
  why->addActions(why_->panel_actions());
  why->addSeparator();
  why->addActions(time_->panel_actions());
  menuBar()->addMenu(tr("&Annotations"))->addActions(annotations_->panel_actions());
  menuBar()->addMenu(tr("&Playback"))->addActions(playback_->panel_actions());
  QMenu* go = menuBar()->addMenu(tr("&Go"));
  auto* trail = new CameraTrail(workbench_, scene(), this);
  go->addAction(trail->back());
  // After the cursor has moved.
  connect(&program_->view(), &ProgramView::line_chosen, trail, &CameraTrail::follow_cursor,
          Qt::QueuedConnection);
  connect(charts_, &ChartsPanel::time_chosen, trail, &CameraTrail::follow_cursor, Qt::QueuedConnection);
  go->addActions(slow_places_->panel_actions());
  go->addActions(contour_->step_actions());
  go->addActions(diagnostics_->panel_actions());

  auto* view = new ViewMenu(*scenes_, workbench_.view_range(), presentation_->actions(), *this);
  menuBar()->addMenu(view);
  connect(view, &ViewMenu::remake_wanted, this, &MainWindow::remake_wanted);
  connect(view, &ViewMenu::first_layout_wanted, this, [this] {
    presentation_->set_on(false);
    wanted_layout_.clear();
    restoreState(first_layout_);
    dock_sizes_->follow_first_layout();
  });
  handouts_ = new HandoutCommand(desk_, QCoreApplication::applicationFilePath(), *this);
  auto* lessons = new LessonMenu(desk_, lessons_->panel_actions() + presentation_->step_actions(),
                                 handouts_->actions(), lessons_->unlock_action(), this);
  menuBar()->addMenu(lessons);
  connect(lessons, &LessonMenu::lesson_wanted, this, &MainWindow::open_lesson);
  auto* help = new HelpMenu(*lessons_, *this);
  menuBar()->addMenu(help);
  connect(start_page_, &StartPage::handbook_wanted, help, &HelpMenu::show_first_steps);
  connect(help, &HelpMenu::start_page_wanted, start_page_, &StartPage::open);

  auto* bar = new SetupBar(workbench_, this);
  addToolBar(bar);
  bar->insert_first({file_menu_->open_program(), undo, redo});
  bar->add_last(setup_->for_all(), decide_->compare(), {file_menu_->picture(), file_menu_->report()});
  connect(bar, &SetupBar::machine_file_wanted, file_menu_, &FileMenu::ask_for_machine);
}

void MainWindow::make_status() {
  auto* status = new StatusPanel(workbench_, scenes_->comparison(), this);
  statusBar()->addPermanentWidget(status);
  auto* not_counted = new StatusNote(this);
  not_counted->setContentsMargins(6, 0, 0, 0);
  statusBar()->addWidget(not_counted);
  connect(&workbench_, &Workbench::run_changed, this, [this, not_counted] {
    const auto shown = workbench_.shown();
    not_counted->setText(shown == nullptr ? QString()
                                          : in_language(not_counted_note(shown->run.summary.not_counted)));
    not_counted->setToolTip(not_counted->text());
  });
  connect(status, &StatusPanel::diagnostics_clicked, diagnostics_, &Panel::attention_wanted);
  connect(this, &MainWindow::cancel_wanted, status, &StatusPanel::cancel);
  connect(this, &MainWindow::cancel_wanted, &workbench_.time_findings(), &TimeFindings::cancel);
  connect(this, &MainWindow::cancel_wanted, versions_, &VersionsView::cancel);
  connect(this, &MainWindow::cancel_wanted, identification_, &IdentificationView::cancel);
  const auto say = [this](const QString& message) { statusBar()->showMessage(message); };
  connect(charts_, &ChartsPanel::exported, this, say);
  connect(file_menu_, &FileMenu::done, this, say);
  connect(file_menu_, &FileMenu::failed, this, &MainWindow::show_failure);
  connect(handouts_, &HandoutCommand::done, this, say);
  connect(handouts_, &HandoutCommand::failed, this, &MainWindow::show_failure);
  connect(&workbench_, &Workbench::noticed, this, [this](const QString& message) {
    constexpr int shown_for = 8000;  // [ms]
    statusBar()->showMessage(message, shown_for);
  });
}

/// Connects requests between panels.
void MainWindow::connect_panels() {
  ProgramView& program = program_->view();
  connect(&program, &ProgramView::caret_moved, this,
          [this, &program] { diagnostics_->set_place(program.caret()); });
  connect(diagnostics_, &DiagnosticsView::place_chosen, program_, &ProgramPanel::go_to);
  connect(contour_, &ContourView::close_up_wanted, &scene(), &SceneView::zoom_to_times);
  scene().set_place_actions(annotations_->panel_actions());
  connect(&scene().annotations(), &AnnotationOverlay::edit_wanted, annotations_, &AnnotationsView::edit);
  annotations_->set_picture(scene().annotations());
  annotations_->set_stretch([this] { return chosen_times(); });
  connect(identification_, &IdentificationView::trace_wanted, traces_, &TraceView::ask_for_file);
  connect(identification_, &IdentificationView::program_wanted, this, &MainWindow::open);
  connect(runs_, &RunsView::trace_chosen, traces_, &TraceView::choose);
  connect(time_, &TimeView::report_wanted, file_menu_, &FileMenu::ask_for_report);
}

void MainWindow::connect_lessons() {
  connect(&desk_, &LessonDesk::failed, this, &MainWindow::show_failure);
  connect(&desk_, &LessonDesk::opening, this,
          [this] { statusBar()->showMessage(tr("Measuring the numbers of the lesson …")); });
  connect(&desk_, &LessonDesk::opened, statusBar(), &QStatusBar::clearMessage);
  connect(&desk_, &LessonDesk::set_up_begins, session_, &WindowSession::set_aside);
  connect(session_, &WindowSession::aside_changed, lessons_, &LessonView::offer_return);
  connect(lessons_, &LessonView::return_wanted, this, [this] {
    desk_.leave_window();
    session_->bring_back();
  });
  connect(&desk_, &LessonDesk::view_wanted, this, &MainWindow::show_lesson);
  connect(presentation_, &Presentation::step_wanted, lessons_, &LessonView::step);
  connect(presentation_, &Presentation::switched, lessons_, &LessonView::set_presenting);
  connect(lessons_, &LessonView::setting_wanted, this, [this](const QString& key) {
    dock_of(*setup_).show();
    dock_of(*setup_).raise();
    setup_->show_key(key == QStringLiteral("tolerance") ? "contour_tolerance_mm" : key.toStdString());
  });
}

void MainWindow::connect_start_page() {
  connect(start_page_, &StartPage::program_wanted, file_menu_, &FileMenu::ask_for_program);
  connect(start_page_, &StartPage::file_wanted, this, &MainWindow::open);
  connect(start_page_, &StartPage::lesson_wanted, this, &MainWindow::open_lesson);
  for (const Panel* panel : panels_) {
    connect(panel, &Panel::attention_wanted, start_page_, &QWidget::hide);
  }
  connect(this, &MainWindow::cancel_wanted, start_page_, &QWidget::hide);
}

void MainWindow::place_start_page() {
  int top = menuBar()->geometry().bottom() + 1;
  for (const QToolBar* bar : findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) {
    top = std::max(top, bar->geometry().bottom() + 1);
  }
  start_page_->cover({0, top, width(), std::max(0, statusBar()->geometry().top() - top)});
}

bool MainWindow::event(QEvent* event) {
  const bool handled = QMainWindow::event(event);
  if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest ||
      event->type() == QEvent::Show) {
    place_start_page();
  }
  if (event->type() == QEvent::Show) {
    settling_.start();
    apply_layout();
  } else if (event->type() == QEvent::Resize && settling_.isActive()) {
    QTimer::singleShot(0, this, &MainWindow::apply_layout);
  }
  return handled;
}

QByteArray MainWindow::layout_to_keep() const {
  return with_checksum(presentation_->usual_layout());
}

void MainWindow::restore_layout(const QByteArray& layout) {
  if (layout.isEmpty()) {
    return;
  }
  presentation_->set_on(false);
  const QByteArray state = checked_state(layout);
  wanted_layout_ = state.isEmpty() ? first_layout_ : state;
  if (isVisible()) {
    apply_layout();
  }
}

/// Restores into a visible window only. For a hidden maximised one, QMainWindow keeps a copy of the layout
/// and restores it again once the window has its size, over layouts restored since.
void MainWindow::apply_layout() {
  if (wanted_layout_.isEmpty() || presentation_->on()) {
    return;
  }
  const bool restored =
      restoreState(wanted_layout_) && std::ranges::all_of(panels_, [this](const Panel* panel) {
        return dockWidgetArea(&dock_of(*panel)) != Qt::NoDockWidgetArea;
      });
  if (restored) {
    dock_sizes_->follow_layout();
  } else {
    restoreState(first_layout_);
    dock_sizes_->follow_first_layout();
  }
  if (!settling_.isActive()) {
    wanted_layout_.clear();
  }
}

MainWindow::Handover MainWindow::hand_over() {
  Handover handover{
      saveGeometry(), session_->hand_over(), panel_states(*this), {}, 0, part<CircularView>().shown()};
  if (desk_.lesson() != nullptr) {
    handover.lesson = desk_.lesson()->file;
    handover.question = desk_.question();
  }
  return handover;
}

void MainWindow::take_over(const Handover& before) {
  restoreGeometry(before.geometry);
  set_panel_states(*this, before.panels);
  session_->take_over(before.session);
  if (before.circular) {
    part<CircularView>().show_again(*before.circular);
  }
  if (!before.lesson.empty()) {
    connect(
        &desk_, &LessonDesk::opened, this,
        [this, question = before.question] { desk_.choose_question(question); }, Qt::SingleShotConnection);
    desk_.open(before.lesson);
  }
}

void MainWindow::show_program() {
  if (workbench_.program() == nullptr) {
    statusBar()->clearMessage();  // it concerned the previous program
  }
  show_title();
}

void MainWindow::show_title() {
  const std::filesystem::path& shown = session_->file().empty() ? workbench_.file() : session_->file();
  const QString name = to_qstring(shown.filename());
  setWindowTitle(name.isEmpty() ? tr("Feedscope") : tr("%1 – Feedscope").arg(name));
}

void MainWindow::open(const std::filesystem::path& file) {
  if (MachineOpening::is_machine(file)) {
    open_machine(file);
    return;
  }
  if (is_section_times_file(file)) {
    identification_->add_table(file);
    return;
  }
  if (TraceView::is_trace(file)) {
    traces_->open(file);
    return;
  }
  if (!session_->may_go()) {
    return;
  }
  if (is_session_file(file)) {
    session_->open(file);
  } else {
    session_->forget_file();
    workbench_.open(file);
  }
}

void MainWindow::open_machine(const std::filesystem::path& file) {
  machines_->open(file);
}

void MainWindow::open_lesson(const std::filesystem::path& file) {
  emit lessons_->attention_wanted();
  desk_.open(file, true);
}

void MainWindow::show_lesson(const LessonWindow& look) {
  const auto colouring = std::ranges::find(all_colourings(), look.colouring, colouring_key);
  if (colouring != all_colourings().end()) {
    SceneState state = scene().state();
    state.colouring = *colouring;
    scene().set_state(state);
  }
  const auto camera = std::ranges::find(lesson_cameras(), look.camera);
  scene().scene().set_standard_view(static_cast<StandardView>(camera - lesson_cameras().begin()));
  ViewRange& range = workbench_.view_range();
  look.chart_range ? range.show_times(look.chart_range->first, look.chart_range->second) : range.fit();
  session_->begin_here();
}

std::optional<std::array<double, 2>> MainWindow::chosen_times() const {
  if (const auto second = charts_->second_cursor()) {
    const double first = workbench_.cursor().state().time;
    return std::array{std::min(first, *second), std::max(first, *second)};
  }
  const ViewRange& range = workbench_.view_range();
  return range.shows_all() ? std::nullopt : std::optional(std::array{range.lower_time(), range.upper_time()});
}

void MainWindow::show_failure(const QString& message) {
  start_page_->hide();  // the message is below it
  diagnostics_->add_message(Severity::error, message);
  emit diagnostics_->attention_wanted();
  statusBar()->showMessage(message);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  open(to_path(event->mimeData()->urls().first().toLocalFile()));
  event->acceptProposedAction();
}

void MainWindow::childEvent(QChildEvent* event) {
  if (auto* tabs = qobject_cast<QTabBar*>(event->child()); tabs != nullptr && event->polished()) {
    tabs->setElideMode(Qt::ElideNone);
    tabs->setUsesScrollButtons(true);
    tabs->installEventFilter(this);
  }
  QMainWindow::childEvent(event);
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (auto* tabs = qobject_cast<QTabBar*>(watched); tabs != nullptr && event->type() == QEvent::Move) {
    // Qt keeps the tabs of an area with one panel outside of the window, where the focus would be invisible.
    tabs->setFocusPolicy(tabs->x() < 0 ? Qt::NoFocus : Qt::TabFocus);
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(session_->may_go());
}

}  // namespace feedscope::ui
