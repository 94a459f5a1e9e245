#pragma once

#include <QString>
#include <QStringList>

#include "ui/report/command_process.h"
#include "ui/window/state_line.h"

namespace feedscope::ui {

/// Writes the file of a dialog by a command of the command line, and says in the dialog how it goes.
class FileWriting : public QObject {
  Q_OBJECT

 public:
  /// `executable`, `command`: as of CommandProcess. `state` outlives this.
  FileWriting(const QString& executable, const QStringList& command, StateLine& state,
              QObject* parent = nullptr);

  /// `option` of the command takes the name of `file`.
  void start(const QStringList& arguments, const QString& option, const QString& file);
  /// What was begun is removed. No signal follows.
  void cancel() { process_.cancel(); }
  bool busy() const { return process_.busy(); }

 signals:
  void progressed(double fraction);
  /// Written, or failed, which the dialog then says.
  void ended();
  /// For the status bar.
  void saved(const QString& message);

 private:
  StateLine& state_;
  QString name_;
  CommandProcess process_;
};

}  // namespace feedscope::ui
