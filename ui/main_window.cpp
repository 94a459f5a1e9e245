#include "ui/main_window.h"

#include <QAction>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QMenuBar>
#include <QMimeData>
#include <QStatusBar>
#include <QStyle>
#include <QVBoxLayout>

#include "ui/views/setup_bar.h"
#include "ui/views/status_panel.h"

namespace feedscope::ui {

namespace {

constexpr QSize default_size(1280, 800);
constexpr int program_width = 270;
constexpr int setup_width = 340;
constexpr int charts_height = 390;

std::filesystem::path to_path(const QString& file) {
  return std::filesystem::path(file.toStdU16String());
}

}  // namespace

MainWindow::MainWindow(RunModel& model, RenderBackend backend, QWidget* parent)
    : QMainWindow(parent),
      model_(model),
      program_(new ProgramView(this)),
      scene_(new SceneView(backend, this)),
      charts_(new ChartsPanel(model.cursor(), this)),
      setup_(new SetupView(model.setup(), this)),
      playback_(new PlaybackBar(model.cursor(), model.playback(), this)),
      diagnostics_(new DiagnosticsView(this)) {
  setWindowTitle(tr("Feedscope"));
  resize(default_size);
  setAcceptDrops(true);
  make_docks();
  make_actions();
  make_view_menu();

  auto* status = new StatusPanel(model_, this);
  statusBar()->addPermanentWidget(status);
  connect(status, &StatusPanel::diagnostics_clicked, diagnostics_dock_, &QDockWidget::raise);

  connect(&model_, &RunModel::program_changed, this, &MainWindow::show_program);
  connect(&model_, &RunModel::run_changed, this, &MainWindow::show_run);
  connect(&model_, &RunModel::failed, this, &MainWindow::show_failure);
  connect(&model_.cursor(), &Cursor::changed, this, &MainWindow::show_cursor);
  connect(scene_, &SceneView::picked, &model_.cursor(), &Cursor::set_time);
  connect(program_, &ProgramView::line_chosen, &model_.cursor(), &Cursor::set_line);
  connect(diagnostics_, &DiagnosticsView::line_chosen, program_, &ProgramView::show_line);
  show_program();
  show_run();
}

void MainWindow::make_docks() {
  auto* centre = new QWidget(this);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(scene_, 1);
  layout->addWidget(playback_);
  setCentralWidget(centre);

  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  QDockWidget* program = add_dock("program", tr("Program"), program_, Qt::LeftDockWidgetArea);
  QDockWidget* setup = add_dock("machine", tr("Machine and control"), setup_, Qt::RightDockWidgetArea);
  charts_dock_ = add_dock("charts", tr("Charts"), charts_, Qt::BottomDockWidgetArea);
  diagnostics_dock_ = add_dock("messages", tr("Messages"), diagnostics_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(charts_dock_, diagnostics_dock_);
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

void MainWindow::make_actions() {
  auto* bar = new SetupBar(model_, this);
  addToolBar(bar);
  QAction* first = bar->actions().isEmpty() ? nullptr : bar->actions().first();

  QMenu* file = menuBar()->addMenu(tr("&File"));
  QAction* open = file->addAction(style()->standardIcon(QStyle::SP_DialogOpenButton), tr("&Open program …"),
                                  this, &MainWindow::ask_for_program);
  open->setShortcut(QKeySequence::Open);
  open->setToolTip(tr("Open an NC program (Ctrl+O)"));
  QAction* reload = file->addAction(style()->standardIcon(QStyle::SP_BrowserReload), tr("&Reload program"),
                                    &model_, &RunModel::reload);
  reload->setShortcut(QKeySequence::Refresh);
  reload->setToolTip(tr("Read the program again (F5)"));
  file->addAction(tr("Open &machine file …"), this, &MainWindow::ask_for_machine);
  file->addSeparator();
  file->addAction(tr("&Quit"), this, &QWidget::close)->setShortcut(QKeySequence::Quit);

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QUndoStack& history = model_.setup().history();
  QAction* undo = history.createUndoAction(this, tr("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setIcon(style()->standardIcon(QStyle::SP_ArrowBack));
  QAction* redo = history.createRedoAction(this, tr("Redo"));
  redo->setShortcut(QKeySequence::Redo);
  redo->setIcon(style()->standardIcon(QStyle::SP_ArrowForward));
  edit->addActions({undo, redo});

  QMenu* run = menuBar()->addMenu(tr("&Run"));
  run->addAction(tr("&Play or pause"), playback_, &PlaybackBar::toggle)->setShortcut(Qt::Key_Space);
  run->addAction(tr("To the &start"), this, [this] { model_.cursor().set_time(0); })
      ->setShortcut(QKeySequence::MoveToStartOfDocument);
  run->addAction(tr("&Cancel simulation"), &model_, &RunModel::cancel)->setShortcut(Qt::Key_Escape);

  bar->insertActions(first, {open, reload, undo, redo});
  bar->insertSeparator(first);
}

void MainWindow::make_view_menu() {
  QMenu* view = menuBar()->addMenu(tr("&View"));
  const auto add = [&](const QString& text, const QKeySequence& key, StandardView standard) {
    view->addAction(text, this, [this, standard] { scene_->scene().set_standard_view(standard); })
        ->setShortcut(key);
  };
  add(tr("&Isometric"), QKeySequence(tr("Ctrl+1")), StandardView::iso);
  add(tr("&Top"), QKeySequence(tr("Ctrl+2")), StandardView::top);
  add(tr("&Front"), QKeySequence(tr("Ctrl+3")), StandardView::front);
  add(tr("&Right"), QKeySequence(tr("Ctrl+4")), StandardView::right);
  view->addAction(tr("Fit &path"), this, [this] { scene_->scene().fit(); })
      ->setShortcut(QKeySequence(tr("Ctrl+0")));
  view->addAction(tr("Fit &charts"), &charts_->range(), &ViewRange::fit)
      ->setShortcut(QKeySequence(tr("Ctrl+Shift+0")));
  view->addSeparator();
  for (const QDockWidget* dock : findChildren<QDockWidget*>()) {
    view->addAction(dock->toggleViewAction());
  }
}

void MainWindow::ask_for_program() {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open NC program"), {},
      tr("NC programs (*.nc *.ngc *.gcode *.tap *.mpf *.spf *.h *.i *.cnc *.iso *.txt);;All files (*)"));
  if (!file.isEmpty()) {
    model_.open(to_path(file));
  }
}

void MainWindow::ask_for_machine() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open machine file"), {}, tr("Machine files (*.toml)"));
  if (!file.isEmpty()) {
    model_.choose_machine(file);
  }
}

void MainWindow::show_program() {
  const auto program = model_.program();
  program_->set_program(program);
  diagnostics_->set_diagnostics(program == nullptr ? std::vector<Diagnostic>() : program->diagnostics);
  const QString name = QString::fromStdU16String(model_.file().filename().u16string());
  setWindowTitle(name.isEmpty() ? tr("Feedscope") : tr("%1 – Feedscope").arg(name));
}

void MainWindow::show_run() {
  const auto shown = model_.shown();
  const bool any = shown != nullptr;
  scene_->scene().set_programmed(any ? shown->run.input.toolpath : nullptr);
  scene_->scene().set_executed(any ? shown->run.trajectory : nullptr, any ? shown->samples : nullptr);
  charts_->set_limits(model_.setup().setup().machine.axes);
  charts_->set_run(any ? shown->run.trajectory : nullptr, any ? shown->envelope : nullptr, any);
  playback_->set_duration(any ? shown->run.trajectory->duration() : 0);
  program_->set_times(any ? shown->line_times : nullptr);
  show_cursor();
}

void MainWindow::show_cursor() {
  const Cursor& cursor = model_.cursor();
  scene_->scene().set_cursor(cursor.valid() ? std::optional(cursor.state().position) : std::nullopt);
  program_->show_line(cursor.valid() ? cursor.state().line : 0);
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
  model_.open(to_path(event->mimeData()->urls().first().toLocalFile()));
  event->acceptProposedAction();
}

}  // namespace feedscope::ui
