#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QInputDialog>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QProcess>
#include <QSettings>
#include <QStatusBar>
#include <QStyle>

#include "core/base/data_folder.h"
#include "ui/dock_sizes.h"
#include "ui/language/language.h"
#include "ui/main_window.h"
#include "ui/models/panel_action.h"
#include "ui/models/recent_files.h"
#include "ui/theme/icons.h"
#include "ui/views/reading_dialog.h"
#include "ui/views/setup_bar.h"
#include "ui/window_pictures.h"

namespace feedscope::ui {

namespace {

std::filesystem::path to_path(const QString& file) {
  return std::filesystem::path(file.toStdU16String());
}

void collect(const QMenu& menu, const QString& place, QList<ListedAction>& list) {
  for (QAction* action : menu.actions()) {
    if (action->menu() != nullptr) {
      collect(*action->menu(), QStringLiteral("%1 › %2").arg(place, plain_text(action->text())), list);
    } else if (!action->isSeparator() && !action->text().isEmpty()) {
      list.append({place, action});
    }
  }
}

}  // namespace

QList<ListedAction> MainWindow::commands() const {
  QList<ListedAction> list;
  for (const QAction* menu : menuBar()->actions()) {
    collect(*menu->menu(), plain_text(menu->text()), list);
  }
  return list;
}

QAction* MainWindow::add_action(QMenu* menu, const QString& text, const QKeySequence& key,
                                const QString& tip) {
  QAction* action = make_action(this, text, tip, key);
  menu->addAction(action);
  return action;
}

void MainWindow::make_menus() {
  auto* bar = new SetupBar(model_, this);
  addToolBar(bar);
  make_file_menu();

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QUndoStack& history = model_.setup().history();
  QAction* undo = history.createUndoAction(this, tr("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setToolTip(tr("Take back the last change of runs and settings"));
  undo->setIcon(edit_icon(EditIcon::undo));
  QAction* redo = history.createRedoAction(this, tr("Redo"));
  redo->setShortcut(QKeySequence::Redo);
  redo->setToolTip(tr("Make the change again that was taken back"));
  redo->setIcon(edit_icon(EditIcon::redo));
  edit->addActions({undo, redo});
  edit->addSeparator();
  edit->addActions(program_->panel_actions());

  QMenu* runs = menuBar()->addMenu(tr("&Runs"));
  runs->addActions(runs_->panel_actions());
  for (const QAction* action : runs_->panel_actions()) {
    connect(action, &QAction::triggered, runs_dock_, &QDockWidget::raise);
  }
  runs->addActions(study_->panel_actions());
  runs->addActions(contour_->panel_actions());
  runs->addSeparator();
  connect(add_action(runs, tr("&Cancel simulation"), Qt::Key_Escape,
                     tr("Stop reading, simulating or comparing runs")),
          &QAction::triggered, this, &MainWindow::cancel_wanted);

  menuBar()->addMenu(tr("&Charts"))->addActions(charts_->panel_actions());
  menuBar()->addMenu(tr("&Why here?"))->addActions(why_->panel_actions());
  menuBar()->addMenu(tr("&Annotations"))->addActions(annotations_->panel_actions());

  QMenu* playback = menuBar()->addMenu(tr("&Playback"));
  playback->addActions(playback_->panel_actions());
  connect(add_action(playback, tr("To the s&tart"), QKeySequence::MoveToStartOfDocument,
                     tr("To the start of the run")),
          &QAction::triggered, this, [this] { model_.cursor().set_time(0); });
  connect(
      add_action(playback, tr("To the &end"), QKeySequence::MoveToEndOfDocument, tr("To the end of the run")),
      &QAction::triggered, this, [this] {
        const auto shown = model_.shown();
        model_.cursor().set_time(shown == nullptr ? 0 : shown->run.trajectory->duration());
      });

  QMenu* go = menuBar()->addMenu(tr("&Go"));
  go->addActions(slow_places_->panel_actions());
  go->addActions(contour_->step_actions());
  go->addActions(diagnostics_->panel_actions());

  make_view_menu();
  make_help_menu();

  QAction* first = bar->actions().isEmpty() ? nullptr : bar->actions().first();
  for (QAction* action : menuBar()->actions().first()->menu()->actions()) {
    if (!action->icon().isNull()) {
      bar->insertAction(first, action);
    }
  }
  bar->insertActions(first, {undo, redo});
  bar->insertSeparator(first);
}

void MainWindow::make_file_menu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  QAction* open =
      add_action(file, tr("&Open program …"), QKeySequence::Open, tr("Open an NC program or a session"));
  open->setIcon(style()->standardIcon(QStyle::SP_DialogOpenButton));
  connect(open, &QAction::triggered, this,
          [this] { ask_for_program(QString::fromStdU16String(model_.file().parent_path().u16string())); });
  connect(add_action(file, tr("Open &sample …"), {}, tr("Open one of the programs that come with Feedscope")),
          &QAction::triggered, this, &MainWindow::ask_for_sample);
  QMenu* recent = file->addMenu(tr("Open &recent"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { list_recent_files(recent); });
  list_recent_files(recent);
  QAction* reload =
      add_action(file, tr("&Reload program"), QKeySequence::Refresh, tr("Read the program again"));
  reload->setIcon(style()->standardIcon(QStyle::SP_BrowserReload));
  connect(reload, &QAction::triggered, &model_, &Workbench::reload);
  QAction* follow = add_action(file, tr("Reload when the file &changes"), {},
                               tr("Read the program again whenever its file is written"));
  follow->setCheckable(true);
  follow->setChecked(QSettings().value("reload_on_change", true).toBool());
  model_.set_reload_on_change(follow->isChecked());
  connect(follow, &QAction::toggled, this, [this](bool on) {
    model_.set_reload_on_change(on);
    QSettings().setValue("reload_on_change", on);
  });
  connect(add_action(file, tr("Reading &options …"), QKeySequence(tr("Ctrl+Shift+R")),
                     tr("Language of the program, cutter radii, limits of loops and calls")),
          &QAction::triggered, this, &MainWindow::ask_how_to_read);
  file->addSeparator();
  connect(add_action(file, tr("&Save session"), QKeySequence::Save,
                     tr("Keep runs, views and annotations in one file")),
          &QAction::triggered, session_, [this] { session_->save(); });
  connect(add_action(file, tr("Save session &as …"), QKeySequence::SaveAs,
                     tr("Keep runs, views and annotations in another file")),
          &QAction::triggered, session_, [this] { session_->save(true); });
  file->addSeparator();
  connect(add_action(file, tr("Open &machine file …"), QKeySequence(tr("Ctrl+M")),
                     tr("Use a machine of your own")),
          &QAction::triggered, this, &MainWindow::ask_for_machine);
  connect(add_action(file, tr("Save machine as …"), QKeySequence(tr("Ctrl+Shift+M")),
                     tr("Write the machine with all changes to a machine file")),
          &QAction::triggered, this, &MainWindow::save_machine);
  file->addSeparator();
  auto* pictures = new WindowPictures(*this);
  file->addMenu(tr("Save &picture"))->addActions(pictures->save_actions());
  file->addMenu(tr("&Copy picture"))->addActions(pictures->copy_actions());
  connect(pictures, &WindowPictures::failed, this, &MainWindow::show_failure);
  connect(pictures, &WindowPictures::saved, this,
          [this](const QString& message) { statusBar()->showMessage(message); });
  file->addSeparator();
  connect(add_action(file, tr("&Quit"), QKeySequence::Quit, tr("Leave Feedscope")), &QAction::triggered, this,
          &QWidget::close);
}

void MainWindow::list_recent_files(QMenu* menu) {
  menu->clear();
  for (const QString& file : RecentFiles::list()) {
    QAction* action = menu->addAction(QFileInfo(file).fileName());
    action->setToolTip(file);
    action->setStatusTip(file);
    connect(action, &QAction::triggered, this, [this, file] { open(to_path(file)); });
  }
  if (menu->isEmpty()) {
    menu->addAction(tr("No program has been opened yet"))->setEnabled(false);
    return;
  }
  menu->addSeparator();
  QAction* forget = menu->addAction(tr("Forget these files"));
  forget->setToolTip(tr("Empty this list and leave the files as they are"));
  connect(forget, &QAction::triggered, this, &RecentFiles::clear);
}

void MainWindow::make_view_menu() {
  QMenu* view = menuBar()->addMenu(tr("&View"));
  scene_->fill_menu(*view);
  view->addActions(scenes_->panel_actions());
  connect(add_action(view, tr("Path of the c&harts"), QKeySequence(tr("Ctrl+9")),
                     tr("The 3D view shows the path between the ends of the charts")),
          &QAction::triggered, this, [this] {
            const ViewRange& range = charts_->range();
            scene_->zoom_to_times(range.time_at(range.lower()), range.time_at(range.upper()));
          });
  view->addSeparator();
  QMenu* docks = view->addMenu(tr("&Panels"));
  for (const QDockWidget* dock : findChildren<QDockWidget*>()) {
    docks->addAction(dock->toggleViewAction());
  }
  docks->addSeparator();
  connect(
      add_action(docks, tr("&Default layout"), {}, tr("All panels where and as large as they were at first")),
      &QAction::triggered, this, [this] {
        restoreState(first_layout_);
        dock_sizes_->follow_first_layout();
      });
  QAction* dark =
      add_action(view, tr("&Dark"), QKeySequence(tr("Ctrl+Shift+D")), tr("Light or dark colours"));
  dark->setCheckable(true);
  dark->setChecked(theme_of(QApplication::palette()) == ThemeKind::dark);
  connect(dark, &QAction::toggled, this,
          [this](bool on) { set_theme(on ? ThemeKind::dark : ThemeKind::light); });
  make_language_menu(view);
}

void MainWindow::make_language_menu(QMenu* view) {
  QMenu* menu = view->addMenu(tr("&Language"));
  auto* group = new QActionGroup(menu);
  for (const QString& code : languages()) {
    const QString name = QLocale(code).nativeLanguageName();
    QAction* action = menu->addAction(name.left(1).toUpper() + name.mid(1));
    action->setCheckable(true);
    action->setChecked(code == chosen_language());
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, code] {
      if (code != chosen_language()) {
        choose_language(code);
        offer_restart();
      }
    });
  }
}

void MainWindow::offer_restart() {
  const auto answer = QMessageBox::question(
      this, tr("Language"),
      tr("The language changes when Feedscope starts again. Restart it now? What is open is opened again."));
  if (answer != QMessageBox::Yes || !session_->may_go()) {
    return;
  }
  const std::filesystem::path& shown = session_->file().empty() ? model_.file() : session_->file();
  const QStringList files =
      shown.empty() ? QStringList() : QStringList(QString::fromStdU16String(shown.u16string()));
  if (QProcess::startDetached(QApplication::applicationFilePath(), files)) {
    QApplication::exit();
  } else {
    show_failure(tr("Feedscope cannot be started again; start it by hand."));
  }
}

void MainWindow::make_help_menu() {
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  connect(add_action(help, tr("&Lessons"), {}, tr("Lessons for courses, with questions about what is shown")),
          &QAction::triggered, this, &MainWindow::raise_lessons);
  QMenu* lesson = help->addMenu(tr("L&esson"));
  lesson->addActions(lessons_->panel_actions());
  help->addSeparator();
  connect(
      add_action(help, tr("&Find a command …"), QKeySequence(tr("Ctrl+K")), tr("Type what you want to do")),
      &QAction::triggered, this, [this] { palette_->ask(commands()); });
  connect(add_action(help, tr("&Keys and mouse"), QKeySequence::HelpContents,
                     tr("All keys, and what the mouse does")),
          &QAction::triggered, this, [this] { key_list_->show_keys(commands()); });
}

void MainWindow::set_theme(ThemeKind kind) {
  apply_theme(kind);
  QSettings().setValue("dark", kind == ThemeKind::dark);
}

void MainWindow::ask_for_sample() {
  ask_for_program(QString::fromStdU16String((data_folder() / "resources" / "programs").u16string()));
}

void MainWindow::ask_for_program(const QString& folder) {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open program or session"), folder,
      tr("NC programs and sessions (*.feedscope *.nc *.ngc *.gcode *.tap *.mpf *.spf *.h *.i *.cnc *.iso "
         "*.txt);;All files (*)"));
  if (!file.isEmpty()) {
    open(to_path(file));
  }
}

void MainWindow::ask_how_to_read() {
  ReadingDialog dialog(model_.reading(), model_.program().get(), this);
  if (dialog.exec() == QDialog::Accepted) {
    model_.set_reading(dialog.options());
  }
}

void MainWindow::ask_for_machine() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open machine file"), {}, tr("Machine files (*.toml)"));
  if (!file.isEmpty()) {
    model_.choose_machine(file);
  }
}

void MainWindow::save_machine() {
  const QString id = QString::fromStdString(model_.setup().file().machine.id);
  QString file = QFileDialog::getSaveFileName(
      this, tr("Save machine as"), id + QStringLiteral("-changed.toml"), tr("Machine files (*.toml)"));
  if (!file.isEmpty()) {
    if (QFileInfo(file).suffix().isEmpty()) {
      file += QStringLiteral(".toml");
    }
    bool accepted = false;
    const QString name =
        QInputDialog::getText(this, tr("Name of the machine"), tr("Name that lists and reports show:"),
                              QLineEdit::Normal, model_.name_to_save(to_path(file)), &accepted);
    if (accepted) {
      model_.save_machine(to_path(file), name);
    }
  }
}

}  // namespace feedscope::ui
