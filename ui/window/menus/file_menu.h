#pragma once

#include <QMenu>
#include <QTemporaryDir>

#include "ui/report/command_process.h"

namespace feedscope::ui {

class MainWindow;
class WindowSession;
class Workbench;

/// Opens, saves and asks for programs, sessions, machine files, pictures, films and reports.
class FileMenu : public QMenu {
  Q_OBJECT

 public:
  /// All outlive this. `window` opens the files, and is the subject of pictures.
  FileMenu(Workbench& workbench, WindowSession& session, MainWindow& window);

  QAction* open_program() const { return open_; }
  QAction* picture() const { return picture_; }
  QAction* report() const { return report_; }

 public slots:
  /// Starts in the folder of the open program.
  void ask_for_program();
  /// Starts among the programs supplied with Feedscope.
  void ask_for_sample();
  /// Asks for a report of the open program in its current view.
  void ask_for_report();
  void ask_for_picture();
  void ask_and_share();
  /// Writes the open program with its runs and annotations as one page for a browser.
  void share(const QString& file);
  /// Prints the contents of the window.
  void ask_and_print();
  void ask_for_film();
  void ask_for_machine();

 signals:
  /// Message for the status bar.
  void done(const QString& message);
  void failed(const QString& message);

 private:
  void add_programs();
  void add_sessions();
  void add_machines();
  void add_paper();
  /// `menu`: a submenu of this one; null: this menu.
  QAction* add(const QString& text, const QKeySequence& key, const QString& tip, QMenu* menu = nullptr);
  void list_recent_files(QMenu* menu);
  /// `folder`: initial folder.
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
