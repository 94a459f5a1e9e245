#include "ui/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QStatusBar>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/analysis/control_dialect.h"
#include "core/analysis/run_notes.h"
#include "core/analysis/unfollowed.h"
#include "ui/dock_sizes.h"
#include "ui/language/core_texts.h"
#include "ui/models/reading_faults.h"
#include "ui/views/annotation_overlay.h"
#include "ui/views/start_hint.h"
#include "ui/views/status_panel.h"

namespace feedscope::ui {

namespace {

constexpr QSize default_size(1280, 800);
constexpr int program_width = 320;
constexpr int setup_width = 371;  // shows every command of the annotations
constexpr int charts_height = 390;

std::filesystem::path to_path(const QString& file) {
  return std::filesystem::path(file.toStdU16String());
}

}  // namespace

MainWindow::MainWindow(Workbench& model, RenderBackend backend, QWidget* parent)
    : QMainWindow(parent),
      model_(model),
      program_(new ProgramPanel(this)),
      scene_(new SceneView(backend, this)),
      scenes_(new SideBySide(model, *scene_, backend, this)),
      charts_(new ChartsPanel(model.cursor(), this)),
      setup_(new SetupView(model.setup(), this)),
      playback_(new PlaybackBar(model.cursor(), model.playback(), this)),
      diagnostics_(new DiagnosticsView(this)),
      slow_places_(new SlowPlacesView(this)),
      runs_(new RunsView(model.runs(), this)),
      notice_(new RunNotice(model, this)),
      start_hint_(new StartHint(model, this)),
      why_(new WhyView(model.cursor(), this)),
      annotations_(new AnnotationsView(model.annotations(), model.cursor(), this)),
      study_(new StudyView(model, this)),
      contour_(new ContourView(model, this)),
      desk_(model),
      lessons_(new LessonView(desk_, this)),
      session_(new WindowSession(*this, model)),
      palette_(new CommandPalette(this)),
      key_list_(new KeyList(this)) {
  setWindowTitle(tr("Feedscope"));
  resize(default_size);
  setAcceptDrops(true);
  make_docks();
  make_menus();
  first_layout_ = saveState();
  dock_sizes_ = new DockSizes(*this, program_width, setup_width, charts_height);

  auto* status = new StatusPanel(model_, scenes_->comparison(), this);
  statusBar()->addPermanentWidget(status);
  connect(status, &StatusPanel::diagnostics_clicked, diagnostics_dock_, &QDockWidget::raise);
  connect(this, &MainWindow::cancel_wanted, status, &StatusPanel::cancel);

  connect(&model_, &Workbench::program_changed, this, &MainWindow::show_program);
  connect(&model_, &Workbench::run_changed, this, &MainWindow::show_run);
  connect(&model_, &Workbench::failed, this, &MainWindow::show_failure);
  connect(&model_, &Workbench::noticed, this, [this](const QString& message) {
    constexpr int shown_for = 8000;  // [ms]
    statusBar()->showMessage(message, shown_for);
  });
  connect(start_hint_, &StartHint::program_wanted, this, [this] { ask_for_program({}); });
  connect(start_hint_, &StartHint::sample_wanted, this, &MainWindow::ask_for_sample);
  connect(start_hint_, &StartHint::lesson_wanted, this, &MainWindow::raise_lessons);
  connect(session_, &WindowSession::file_changed, this, &MainWindow::show_title);
  connect(session_, &WindowSession::failed, this, &MainWindow::show_failure);
  connect(session_, &WindowSession::noticed, this,
          [this](const QString& message) { diagnostics_->add_message(Severity::info, message); });
  connect(&model_.cursor(), &Cursor::changed, this, &MainWindow::show_cursor);
  connect(playback_, &PlaybackBar::loop_wanted, this, &MainWindow::loop_what_is_shown);
  connect(scene_, &SceneView::picked, &model_.cursor(), &Cursor::set_time);
  connect(scene_, &SceneView::times_chosen, this, &MainWindow::show_times);
  connect(&charts_->range(), &ViewRange::changed, this, [this] {
    const ViewRange& range = charts_->range();
    scene_->show_times(range.time_at(range.lower()), range.time_at(range.upper()));
  });
  connect(&program(), &ProgramView::line_chosen, &model_.cursor(), &Cursor::set_line);
  connect(&program(), &ProgramView::caret_moved, this,
          [this] { diagnostics_->set_place(program().caret()); });
  connect(diagnostics_, &DiagnosticsView::place_chosen, program_, &ProgramPanel::go_to);
  connect(slow_places_, &SlowPlacesView::place_chosen, this, &MainWindow::show_place);
  connect(contour_, &ContourView::failed, this, &MainWindow::show_failure);
  connect(contour_, &ContourView::place_chosen, this,
          [this](double time, double from, double to, bool close_up) {
            show_place(time, from, to);
            if (close_up) {
              scene_->zoom_to_times(from, to);
            }
          });
  connect(why_, &WhyView::time_chosen, &model_.cursor(), &Cursor::set_time);
  connect(why_, &WhyView::run_wanted, this,
          [this](const SetupState& setup) { model_.runs().duplicate_as(model_.runs().current(), setup); });
  connect(runs_, &RunsView::again_wanted, &model_, &Workbench::simulate_again);
  connect(&model_.runs(), &RunList::item_changed, this, &MainWindow::show_run_name);
  connect(scenes_, &SideBySide::mode_changed, this, &MainWindow::show_other_runs);
  scene_->annotations().set_annotations(&model_.annotations());
  scene_->set_place_actions(annotations_->panel_actions());
  annotations_->set_stretch([this] { return chosen_times(); });
  connect(&scene_->annotations(), &AnnotationOverlay::edit_wanted, annotations_, &AnnotationsView::edit);
  connect(annotations_, &AnnotationsView::time_chosen, &model_.cursor(), &Cursor::set_time);
  connect(&desk_, &LessonDesk::failed, this, &MainWindow::show_failure);
  connect(&desk_, &LessonDesk::view_wanted, this, &MainWindow::show_lesson);
  connect(charts_, &ChartsPanel::failed, this, &MainWindow::show_failure);
  connect(charts_, &ChartsPanel::exported, this,
          [this](const QString& message) { statusBar()->showMessage(message); });
  for (const auto signal : {&RunList::list_changed, &RunList::current_changed}) {
    connect(&model_.runs(), signal, this, &MainWindow::show_other_runs);
  }
  for (const auto signal : {&RunList::item_changed, &RunList::result_changed}) {
    connect(&model_.runs(), signal, this, &MainWindow::show_other_runs);
  }
  show_program();
  show_run();
}

void MainWindow::make_docks() {
  auto* centre = new QWidget(this);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(notice_);
  layout->addWidget(scenes_, 1);
  layout->addWidget(start_hint_);
  layout->addWidget(playback_);
  playback_->setVisible(start_hint_->isHidden());
  connect(start_hint_, &StartHint::shown, playback_, &QWidget::setHidden);
  setCentralWidget(centre);

  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  QDockWidget* program = add_dock("program", tr("Program"), program_, Qt::LeftDockWidgetArea);
  QDockWidget* setup = add_dock("machine", tr("Machine and control"), setup_, Qt::RightDockWidgetArea);
  QDockWidget* why = add_dock("why", tr("Why here?"), why_, Qt::RightDockWidgetArea);
  tabifyDockWidget(setup, why);
  QDockWidget* notes = add_dock("annotations", tr("Annotations"), annotations_, Qt::RightDockWidgetArea);
  tabifyDockWidget(setup, notes);
  connect(annotations_, &AnnotationsView::attention_wanted, notes, [notes] {
    notes->show();
    notes->raise();
  });
  lesson_dock_ = add_dock("lesson", tr("Lesson"), lessons_, Qt::RightDockWidgetArea);
  tabifyDockWidget(setup, lesson_dock_);
  lesson_dock_->hide();
  connect(lessons_, &LessonView::setting_wanted, setup, [this, setup](const QString& key) {
    setup->raise();
    setup_->show_key(key == QStringLiteral("tolerance") ? "contour_tolerance_mm" : key.toStdString());
  });
  setup->raise();
  connect(why, &QDockWidget::visibilityChanged, why_, &WhyView::set_on_screen);
  connect(why_, &WhyView::attention_wanted, why, [why] {
    why->show();
    why->raise();
  });
  charts_dock_ = add_dock("charts", tr("Charts"), charts_, Qt::BottomDockWidgetArea);
  diagnostics_dock_ = add_dock("messages", tr("Messages"), diagnostics_, Qt::BottomDockWidgetArea);
  runs_dock_ = add_dock("runs", tr("Runs"), runs_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(charts_dock_, runs_dock_);
  QDockWidget* slow = add_dock("slow-places", tr("Slow places"), slow_places_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(charts_dock_, slow);
  tabifyDockWidget(charts_dock_, diagnostics_dock_);
  QDockWidget* study = add_dock("study", tr("Study"), study_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(charts_dock_, study);
  study->hide();
  connect(study_, &StudyView::attention_wanted, study, [study] {
    study->show();
    study->raise();
  });
  QDockWidget* contour = add_dock("contour", tr("Contour error"), contour_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(charts_dock_, contour);
  contour->hide();
  connect(contour, &QDockWidget::visibilityChanged, contour_, &ContourView::set_on_screen);
  connect(contour_, &ContourView::attention_wanted, contour, [contour] {
    contour->show();
    contour->raise();
  });
  charts_dock_->raise();
  resizeDocks({program, setup}, {program_width, setup_width}, Qt::Horizontal);
  resizeDocks({charts_dock_}, {charts_height}, Qt::Vertical);
}

QDockWidget* MainWindow::add_dock(const QString& name, const QString& title, QWidget* content,
                                  Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  addDockWidget(area, dock);
  return dock;
}

void MainWindow::restore_layout(const QByteArray& layout) {
  if (restoreState(layout)) {
    dock_sizes_->follow_layout();
  }
}

void MainWindow::show_program() {
  const auto program = model_.program();
  if (program == nullptr) {
    statusBar()->clearMessage();  // it was about the program before
  }
  program_->set_program(program);
  diagnostics_->set_program(program);
  annotations_->set_toolpath(model_.shown_program().input.toolpath);
  scene_->scene().set_programmed(model_.shown_program().samples);
  scene_->scene().set_warning(program == nullptr ? "" : reading_faults_text(*program).toStdString());
  if (program != nullptr && std::exchange(fitted_to_, model_.file()) != model_.file()) {
    scene_->scene().fit();  // the place of the program before means nothing in this one
    charts_->show_all_curves();
  }
  show_title();
}

void MainWindow::show_title() {
  const std::filesystem::path& shown = session_->file().empty() ? model_.file() : session_->file();
  const QString name = QString::fromStdU16String(shown.filename().u16string());
  setWindowTitle(name.isEmpty() ? tr("Feedscope") : tr("%1 – Feedscope").arg(name));
}

void MainWindow::open(const std::filesystem::path& file) {
  if (!session_->may_go()) {
    return;
  }
  if (is_session_file(file)) {
    session_->open(file);
  } else {
    session_->forget_file();
    model_.open(file);
  }
}

void MainWindow::show_run() {
  const auto shown = model_.shown();
  const bool any = shown != nullptr;
  const auto program_text = model_.program();
  scene_->scene().set_programmed(any && shown->programmed != nullptr ? shown->programmed
                                                                     : model_.shown_program().samples);
  scene_->scene().set_warning((any                       ? picture_warning(shown->run)
                               : program_text != nullptr ? reading_faults_text(*program_text)
                                                         : QString())
                                  .toStdString());
  scenes_->show_current();
  show_run_name();
  charts_->set_limits(model_.setup().setup().machine.axes);
  charts_->set_run(any ? shown->run.trajectory : nullptr, any ? shown->envelope : nullptr,
                   model_.program() != nullptr);
  playback_->set_duration(any ? shown->run.trajectory->duration() : 0);
  slow_places_->set_places(any ? shown->slow_places : nullptr);
  program().set_times(any ? shown->line_times : nullptr);
  why_->set_run(shown, model_.setup().state());
  show_unfollowed();
  const Settings& settings = model_.setup().file().settings;
  if (settings.has("interpolation_period_s")) {
    const double period = std::get<double>(model_.setup().state().value("interpolation_period_s"));
    playback_->set_sample_time(period);
    charts_->set_sample_time(period);
  }
  show_cursor();
}

void MainWindow::show_run_name() {
  const auto shown = model_.shown();
  scene_->annotations().set_run(shown != nullptr ? shown->run.trajectory : nullptr,
                                model_.runs().title(model_.runs().current_item()));
}

void MainWindow::show_unfollowed() {
  QStringList sentences;
  if (const auto shown = model_.shown(); shown != nullptr) {
    if (const auto mismatch = control_mismatch(shown->run.setup.machine, shown->run.input.program->dialect)) {
      const QString dialect = QString::fromUtf8(info_of(mismatch->dialect).title.data());
      sentences.append(
          tr("The program is written for %1; this machine has a %2, whose path and times are shown.")
              .arg(dialect, QString::fromStdString(mismatch->control)));
    }
    const std::string offsets = unused_work_offsets(*shown->run.input.program, shown->run.setup.machine);
    if (!offsets.empty()) {
      sentences.append(tr("The program was read with other work offsets than those of this machine (%1); "
                          "reload it to use them.")
                           .arg(QString::fromStdString(offsets)));
    }
    for (const std::string& sentence : unfollowed(shown->run.input, shown->run.setup)) {
      sentences.append(core_text(sentence));
    }
    if (const QString events = not_counted_text(shown->run.summary.not_counted); !events.isEmpty()) {
      sentences.append(events + '.');
    }
  }
  setup_->show_unfollowed(sentences);
}

void MainWindow::show_other_runs() {
  const RunList& runs = model_.runs();
  std::vector<RunOverlay> in_charts;
  std::vector<OverlayRun> in_scene;
  const auto rgb = [](const QColor& colour) { return Rgb{colour.redF(), colour.greenF(), colour.blueF()}; };
  for (std::size_t row = 0; row < runs.items().size(); ++row) {
    const auto result = runs.result(row);
    const RunItem& item = runs.items()[row];
    if (row != runs.current() && item.visible && result != nullptr) {
      in_charts.push_back({result->run.trajectory, result->envelope, item.colour, runs.title(item)});
      if (scenes_->mode() != ScenesMode::split) {  // where the other run has its half
        in_scene.push_back({result->samples, rgb(item.colour), runs.title(item).toStdString()});
      }
    }
  }
  charts_->set_overlays(std::move(in_charts));
  scene_->scene().set_run_colour(rgb(runs.current_item().colour));
  scene_->scene().set_overlays(std::move(in_scene));
}

void MainWindow::raise_lessons() {
  lesson_dock_->show();
  lesson_dock_->raise();
}

void MainWindow::open_lesson(const std::filesystem::path& file) {
  raise_lessons();
  desk_.open(file, true);
}

void MainWindow::show_lesson(const LessonWindow& look) {
  const auto colouring = std::ranges::find(all_colourings, look.colouring, colouring_key);
  if (colouring != all_colourings.end()) {
    SceneState state = scene_->state();
    state.colouring = *colouring;
    scene_->set_state(state);
  }
  const auto camera = std::ranges::find(lesson_cameras(), look.camera);
  scene_->scene().set_standard_view(static_cast<StandardView>(camera - lesson_cameras().begin()));
  if (look.chart_range) {
    show_times(look.chart_range->first, look.chart_range->second);
  } else {
    charts_->range().fit();
  }
  session_->begin_here();
}

void MainWindow::show_times(double from, double to) {
  if (const auto shown = model_.shown()) {
    ViewRange& range = charts_->range();
    range.show(range.position_of(shown->run.trajectory->state(from)),
               range.position_of(shown->run.trajectory->state(to)));
  }
}

std::array<double, 2> MainWindow::chosen_times() const {
  if (const auto second = charts_->second_cursor()) {
    const double first = model_.cursor().state().time;
    return {std::min(first, *second), std::max(first, *second)};
  }
  const ViewRange& range = charts_->range();
  return {range.time_at(range.lower()), range.time_at(range.upper())};
}

void MainWindow::loop_what_is_shown(bool on) {
  const ViewRange& range = charts_->range();
  model_.playback().set_loop(
      on ? std::optional(Playback::Loop{range.time_at(range.lower()), range.time_at(range.upper())})
         : std::nullopt);
}

void MainWindow::show_cursor() {
  const Cursor& cursor = model_.cursor();
  cursor.valid() ? scene_->scene().set_cursor(cursor.state()) : scene_->scene().set_cursor(std::nullopt);
  program().show_line(cursor.valid() ? cursor.state().line : 0);
  slow_places_->set_time(cursor.valid() ? cursor.state().time : 0);
}

void MainWindow::show_place(double time, double from, double to) {
  const auto shown = model_.shown();
  if (shown == nullptr) {
    return;
  }
  model_.cursor().set_time(time);
  ViewRange& range = charts_->range();
  const Trajectory& trajectory = *shown->run.trajectory;
  const double around = to - from;  // as much before and behind
  range.show(range.position_of(trajectory.state(from - around)),
             range.position_of(trajectory.state(to + around)));
}

void MainWindow::show_failure(const QString& message) {
  diagnostics_->add_message(Severity::error, message);
  diagnostics_dock_->raise();
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
  }
  QMainWindow::childEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(session_->may_go());
}

}  // namespace feedscope::ui
