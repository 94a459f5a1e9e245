#pragma once

#include <QString>
#include <QStringList>

#include "ui/report/command_process.h"
#include "ui/window/panels/state_line.h"

namespace feedscope::ui {

/// Writes the file of a dialog by a command of the command line, and shows its progress in the dialog.
class FileWriting : public QObject {
  Q_OBJECT

 public:
  /// `executable`, `command`: as of CommandProcess. `state` outlives this.
  FileWriting(const QString& executable, const QStringList& command, StateLine& state,
              QObject* parent = nullptr);

  /// `option` of the command gets the name of `file`.
  void start(const QStringList& arguments, const QString& option, const QString& file);
  /// Removes the partial file. No signal follows.
  void cancel() { process_.cancel(); }
  bool busy() const { return process_.busy(); }

 signals:
  void progressed(double fraction);
  /// Written, or failed with a message in the dialog.
  void ended();
  /// Message for the status bar.
  void saved(const QString& message);

 private:
  StateLine& state_;
  QString name_;
  CommandProcess process_;
};

}  // namespace feedscope::ui
