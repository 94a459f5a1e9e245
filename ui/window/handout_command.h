#pragma once

#include <QWidget>
#include <filesystem>

#include "ui/lessons/lesson_desk.h"
#include "ui/report/command_process.h"

class QAction;

namespace feedscope::ui {

/// The hand-out of the open lesson as a file to print, with pictures, made by `feedscope lessons` in a
/// process of its own: the window goes on, and the pages are those of the command line, in the language of
/// the lesson.
class HandoutCommand : public QObject {
  Q_OBJECT

 public:
  /// `desk` outlives this. `executable`: the program with the command `lessons`.
  HandoutCommand(const LessonDesk& desk, QString executable, QWidget& window);

  /// Asks for the file; enabled while a lesson is open.
  QAction* action() const { return action_; }
  /// PDF or HTML by the ending of `file`. done() or failed() follows. One at a time: another one ends the one
  /// under way.
  void write(const QString& file);

 signals:
  void done(const QString& message);
  void failed(const QString& message);

 private:
  void ask();

  const LessonDesk& desk_;
  QWidget& window_;
  QAction* action_;
  CommandProcess process_;
  QString file_;
};

}  // namespace feedscope::ui
