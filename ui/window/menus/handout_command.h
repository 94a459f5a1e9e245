#pragma once

#include <QList>
#include <QStringList>
#include <QTemporaryFile>
#include <QWidget>
#include <memory>

#include "core/lessons/handout.h"
#include "ui/lessons/lesson_desk.h"
#include "ui/report/command_process.h"

class QAction;

namespace feedscope::ui {

/// Hand-outs of the open lesson as files for printing, with pictures, made by `feedscope lessons` in a
/// separate process: the window remains usable, and the pages are those of the command line, in the language
/// of the lesson. Copies that are not for the teacher contain the answers and tries of the window.
class HandoutCommand : public QObject {
  Q_OBJECT

 public:
  /// `desk` outlives this. `executable`: the program with the command `lessons`.
  HandoutCommand(const LessonDesk& desk, QString executable, QWidget& window);

  /// Actions for learners, for the teacher, for everybody; each asks for the file. Enabled while a lesson is
  /// open.
  QList<QAction*> actions() const { return actions_; }
  /// PDF or HTML by the ending of `file`. done() or failed() follows. One at a time: a new one cancels the
  /// running one.
  void write(HandoutReader reader, const QString& file);
  /// Arguments of `feedscope lessons` for a hand-out of the open lesson, without the output file.
  static QStringList arguments(const Lesson& lesson, HandoutReader reader);

 signals:
  void done(const QString& message);
  void failed(const QString& message);

 private:
  void add(HandoutReader reader, const QString& text, const QString& tip);
  void ask(HandoutReader reader);

  const LessonDesk& desk_;
  QWidget& window_;
  QList<QAction*> actions_;
  CommandProcess process_;
  std::unique_ptr<QTemporaryFile> work_;  ///< of the learner, for the running process
  QString file_;
};

}  // namespace feedscope::ui
