#include "ui/window/menus/file_menu.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QSettings>
#include <filesystem>

#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "ui/charts/charts_panel.h"
#include "ui/language/in_language.h"
#include "ui/language/language.h"
#include "ui/program_text/reading_dialog.h"
#include "ui/session/session_file.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/window/dialogs/film_dialog.h"
#include "ui/window/dialogs/picture_dialog.h"
#include "ui/window/dialogs/print_dialog.h"
#include "ui/window/dialogs/proposed_file.h"
#include "ui/window/dialogs/report_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/picture_commands.h"
#include "ui/workbench/recent_files.h"

namespace feedscope::ui {

FileMenu::FileMenu(Workbench& workbench, WindowSession& session, MainWindow& window)
    : QMenu(tr("&File"), &window),
      workbench_(workbench),
      session_(session),
      window_(window),
      sharing_(QCoreApplication::applicationFilePath(), {QStringLiteral("report")}) {
  add_programs();
  addSeparator();
  add_sessions();
  addSeparator();
  add_machines();
  addSeparator();
  add_paper();
  addSeparator();
  connect(add(tr("&Quit"), QKeySequence::Quit, tr("Quit Feedscope")), &QAction::triggered, &window_,
          &QWidget::close);
}

QAction* FileMenu::add(const QString& text, const QKeySequence& key, const QString& tip, QMenu* menu) {
  QAction* action = make_action(&window_, text, tip, key);
  (menu == nullptr ? this : menu)->addAction(action);
  return action;
}

void FileMenu::add_programs() {
  open_ = add(tr("&Open program …"), QKeySequence::Open, tr("Open an NC program or a session"));
  open_->setIconText(tr("Open …"));
  connect(open_, &QAction::triggered, this, &FileMenu::ask_for_program);
  connect(add(tr("Open &sample …"), {}, tr("Open one of the sample programs supplied with Feedscope")),
          &QAction::triggered, this, &FileMenu::ask_for_sample);
  QMenu* recent = addMenu(tr("Open &recent"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { list_recent_files(recent); });
  list_recent_files(recent);
  QMenu* reading = addMenu(tr("Rea&ding"));
  QAction* reload = add(tr("&Reload program"), QKeySequence::Refresh, tr("Reload the program"), reading);
  connect(reload, &QAction::triggered, &workbench_, &Workbench::reload);
  QAction* follow = add(tr("Reload when the file &changes"), {},
                        tr("Reload the program whenever its file is written"), reading);
  follow->setCheckable(true);
  follow->setChecked(QSettings().value("reload_on_change", true).toBool());
  workbench_.set_reload_on_change(follow->isChecked());
  connect(follow, &QAction::toggled, this, [this](bool on) {
    workbench_.set_reload_on_change(on);
    QSettings().setValue("reload_on_change", on);
  });
  connect(add(tr("Program import &options …"), QKeySequence(tr("Ctrl+Shift+R")),
              tr("Dialect of the program, cutter radii, limits of loops and calls"), reading),
          &QAction::triggered, this, &FileMenu::ask_how_to_read);
}

void FileMenu::add_sessions() {
  connect(add(tr("&Save session"), QKeySequence::Save, tr("Save runs, views and annotations in one file")),
          &QAction::triggered, &session_, [this] { session_.save(); });
  connect(add(tr("Save session &as …"), QKeySequence::SaveAs,
              tr("Save runs, views and annotations in another file")),
          &QAction::triggered, &session_, [this] { session_.save(true); });
}

void FileMenu::add_machines() {
  QMenu* machine = addMenu(tr("&Machine"));
  connect(add(tr("Open &machine file …"), QKeySequence(tr("Ctrl+M")),
              tr("Open a machine file of your own, or the configuration of a control"), machine),
          &QAction::triggered, this, &FileMenu::ask_for_machine);
  connect(add(tr("Save machine as …"), QKeySequence(tr("Ctrl+Shift+M")),
              tr("Save the machine with all changes as a machine file"), machine),
          &QAction::triggered, this, &FileMenu::save_machine);
}

void FileMenu::add_paper() {
  QAction* print = add(tr("P&rint …"), QKeySequence::Print,
                       tr("Print the 3D view, charts, sheet, report, a hand-out or a table, with a preview"));
  set_everyday_words(print, tr("printer paper hard copy"));
  connect(print, &QAction::triggered, this, &FileMenu::ask_and_print);
  report_ = add(tr("Re&port …"), QKeySequence(tr("Ctrl+Alt+R")),
                tr("Report as PDF or HTML, to print or to send, with a preview of its pages"));
  set_everyday_words(report_, tr("print printer export paper document send"));
  connect(report_, &QAction::triggered, this, &FileMenu::ask_for_report);
  QAction* page =
      add(tr("Share as pa&ge …"), {},
          tr("One file that opens in any browser: path in 3D, charts, decision and report, without network"));
  set_everyday_words(page, tr("web browser html send colleague customer tablet"));
  connect(page, &QAction::triggered, this, &FileMenu::ask_and_share);
  connect(&sharing_, &CommandProcess::done, this,
          [this] { emit done(tr("Saved as %1.").arg(shared_file_)); });
  connect(&sharing_, &CommandProcess::failed, this, &FileMenu::failed);
  const auto follow = [this, page] {
    report_->setEnabled(workbench_.program() != nullptr);
    page->setEnabled(workbench_.program() != nullptr);
  };
  connect(&workbench_, &Workbench::program_changed, report_, follow);
  follow();
  auto* pictures = new PictureCommands(window_);
  QMenu* images = addMenu(tr("Pi&ctures"));
  for (QAction* action : pictures->actions()) {
    set_everyday_words(action, tr("export image screenshot print"));
  }
  picture_ = add(
      tr("P&icture …"), QKeySequence(tr("Ctrl+Alt+P")),
      tr("Picture of a chosen size, with a preview: 3D view, charts, sheet or window, as PNG, SVG or PDF"),
      images);
  set_everyday_words(picture_, tr("export image screenshot print dpi poster"));
  connect(picture_, &QAction::triggered, this, &FileMenu::ask_for_picture);
  connect(&workbench_, &Workbench::program_changed, picture_,
          [this] { picture_->setEnabled(workbench_.program() != nullptr); });
  picture_->setEnabled(workbench_.program() != nullptr);
  QAction* film =
      add(tr("&Film …"), {},
          tr("Film of a stretch of the run: the 3D view with the moving tool, with charts below if "
             "wanted"),
          images);
  set_everyday_words(film, tr("video movie animation export record"));
  connect(film, &QAction::triggered, this, &FileMenu::ask_for_film);
  const auto follow_run = [this, film] { film->setEnabled(workbench_.shown() != nullptr); };
  connect(&workbench_, &Workbench::run_changed, film, follow_run);
  follow_run();
  images->addMenu(tr("&Copy picture"))->addActions(pictures->actions());
}

void FileMenu::list_recent_files(QMenu* menu) {
  menu->clear();
  for (const QString& file : RecentFiles::list()) {
    QAction* action = menu->addAction(QFileInfo(file).fileName());
    action->setToolTip(file);
    action->setStatusTip(file);
    connect(action, &QAction::triggered, this, [this, file] { window_.open(to_path(file)); });
  }
  if (menu->isEmpty()) {
    menu->addAction(tr("No program has been opened yet"))->setEnabled(false);
    return;
  }
  menu->addSeparator();
  QAction* forget = menu->addAction(tr("Clear list"));
  forget->setToolTip(tr("Empty this list; the files are kept"));
  connect(forget, &QAction::triggered, this, &RecentFiles::clear);
}

void FileMenu::ask_for_program() {
  ask_for_program_in(to_qstring(workbench_.file().parent_path()));
}

void FileMenu::ask_for_sample() {
  ask_for_program_in(to_qstring(data_folder() / "resources" / "programs"));
}

void FileMenu::ask_for_program_in(const QString& folder) {
  const QString file = QFileDialog::getOpenFileName(
      &window_, tr("Open program or session"), folder,
      tr("NC programs and sessions (*.feedscope *.nc *.ngc *.gcode *.tap *.mpf *.spf *.h *.i *.cnc *.iso "
         "*.txt);;All files (*)"));
  if (!file.isEmpty()) {
    window_.open(to_path(file));
  }
}

void FileMenu::ask_for_report() {
  if (workbench_.program() == nullptr) {
    return;
  }
  constexpr double long_simulation = 5;  // of one run [s]
  ReportDialog::Subject subject;
  subject.session = session_.capture();
  subject.run_names = run_titles(workbench_.runs().items(), workbench_.runs().feed_controls());
  const auto shown = workbench_.shown();
  subject.takes_long = shown != nullptr && shown->run.simulate_time > long_simulation;
  auto* dialog = new ReportDialog(std::move(subject), QCoreApplication::applicationFilePath(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ReportDialog::saved, this, &FileMenu::done);
  dialog->open();
}

void FileMenu::ask_and_share() {
  QString file = QFileDialog::getSaveFileName(
      &window_, tr("Share as page"),
      proposed_file(workbench_.file(), QStringLiteral("page"), QStringLiteral("html")),
      tr("Web page (*.html)"));
  if (!file.isEmpty()) {
    if (QFileInfo(file).suffix().isEmpty()) {
      file += QStringLiteral(".html");
    }
    share(file);
  }
}

void FileMenu::share(const QString& file) {
  const QString session = QDir(share_folder_.path()).filePath(QStringLiteral("page.feedscope"));
  const Session captured = session_.capture();
  ReportWish wish;
  wish.language = spoken_language();
  wish.without.append(QStringLiteral("commands"));
  try {
    write_session(captured, to_path(session));
  } catch (const InputError& error) {
    emit failed(failure_text(error));
    return;
  }
  shared_file_ = file;
  sharing_.start(report_arguments(wish, session) + QStringList{QStringLiteral("--out"), file}, {});
}

void FileMenu::ask_and_print() {
  auto* dialog = new PrintDialog(print_subject(window_), QCoreApplication::applicationFilePath(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PrintDialog::printed, this, &FileMenu::done);
  dialog->open();
}

void FileMenu::ask_for_picture() {
  if (workbench_.program() == nullptr) {
    return;
  }
  auto* dialog =
      new PictureDialog({session_.capture(), window_.scene().canvas().size(),
                         window_.part<ChartsPanel>().size(), window_.size(), window_.scene().text_scale()},
                        QCoreApplication::applicationFilePath(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PictureDialog::saved, this, &FileMenu::done);
  dialog->open();
}

void FileMenu::ask_for_film() {
  const auto shown = workbench_.shown();
  if (shown == nullptr) {
    return;
  }
  const ViewRange& range = workbench_.view_range();
  auto* dialog = new FilmDialog({session_.capture(),
                                 shown->run.trajectory->duration(),
                                 {range.lower_time(), range.upper_time()},
                                 window_.scene().canvas().size()},
                                QCoreApplication::applicationFilePath(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &FilmDialog::saved, this, &FileMenu::done);
  dialog->open();
}

void FileMenu::ask_how_to_read() {
  ReadingDialog dialog(workbench_.reading(), workbench_.program().get(), &window_);
  if (dialog.exec() == QDialog::Accepted) {
    workbench_.set_reading(dialog.options());
  }
}

void FileMenu::ask_for_machine() {
  const QString file =
      QFileDialog::getOpenFileName(&window_, tr("Open machine file"), {},
                                   tr("Machine files and configurations of controls (*.toml *.ini *.cfg *.g "
                                      "*.txt *.tea *.mp);;All files (*)"));
  if (!file.isEmpty()) {
    window_.open_machine(to_path(file));
  }
}

void FileMenu::save_machine() {
  const QString id = QString::fromStdString(workbench_.setup().file().machine.id);
  QString file = QFileDialog::getSaveFileName(
      &window_, tr("Save machine as"), id + QStringLiteral("-changed.toml"), tr("Machine files (*.toml)"));
  if (!file.isEmpty()) {
    if (QFileInfo(file).suffix().isEmpty()) {
      file += QStringLiteral(".toml");
    }
    bool accepted = false;
    const QString name =
        QInputDialog::getText(&window_, tr("Name of the machine"), tr("Name shown in lists and reports:"),
                              QLineEdit::Normal, workbench_.name_to_save(to_path(file)), &accepted);
    if (accepted) {
      workbench_.save_machine(to_path(file), name);
    }
  }
}

}  // namespace feedscope::ui
