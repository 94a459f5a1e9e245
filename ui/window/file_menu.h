#pragma once

#include <QMenu>
#include <QTemporaryDir>

#include "ui/report/command_process.h"

namespace feedscope::ui {

class MainWindow;
class WindowSession;
class Workbench;

/// Programs, sessions, machine files, pictures, films and reports: opened, saved, and asked for.
class FileMenu : public QMenu {
  Q_OBJECT

 public:
  /// All outlive this. `window` opens the files, and is what pictures show.
  FileMenu(Workbench& workbench, WindowSession& session, MainWindow& window);

  QAction* open_program() const { return open_; }
  QAction* picture() const { return picture_; }
  QAction* report() const { return report_; }

 public slots:
  /// Where the program is that is open.
  void ask_for_program();
  /// Among those supplied with Feedscope.
  void ask_for_sample();
  /// Of the program that is open, as it is shown now.
  void ask_for_report();
  void ask_for_picture();
  void ask_and_share();
  /// The program that is open with its runs and annotations, as one page for a browser.
  void share(const QString& file);
  /// What the window shows.
  void ask_and_print();
  void ask_for_film();
  void ask_for_machine();

 signals:
  /// For the status bar.
  void done(const QString& message);
  void failed(const QString& message);

 private:
  void add_programs();
  void add_sessions();
  void add_machines();
  void add_paper();
  /// `menu`: below this one; null: here.
  QAction* add(const QString& text, const QKeySequence& key, const QString& tip, QMenu* menu = nullptr);
  void list_recent_files(QMenu* menu);
  /// `folder`: where the search begins.
  void ask_for_program_in(const QString& folder);
  void ask_how_to_read();
  void save_machine();

  Workbench& workbench_;
  WindowSession& session_;
  MainWindow& window_;
  QAction* open_ = nullptr;
  QAction* picture_ = nullptr;
  QAction* report_ = nullptr;
  QTemporaryDir share_folder_;
  QString shared_file_;
  CommandProcess sharing_;
};

}  // namespace feedscope::ui
