#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

namespace feedscope::ui {

/// Runs a command of the command line, such as `feedscope report`, in a process of its own: the window goes
/// on, and the bytes are those of the command line. One at a time: another one ends the one under way, of
/// which nothing more is heard. It removes what it has begun to write, which nobody waits for but this when
/// it goes.
class CommandProcess : public QObject {
  Q_OBJECT

 public:
  /// `executable`: the program; `command`: its first arguments.
  CommandProcess(QString executable, QStringList command, QObject* parent = nullptr);
  ~CommandProcess() override;

  /// `arguments`: behind those of the command; `folder`: where relative names of files are.
  void start(const QStringList& arguments, const QString& folder);
  /// No signal follows.
  void cancel();
  bool busy() const { return process_ != nullptr && process_->state() != QProcess::NotRunning; }

 signals:
  void progressed(double fraction);
  void done();
  /// For the user: what the command says of it.
  void failed(const QString& message);

 private:
  void read();
  void forget(const QProcess* ended);
  void end(int code, QProcess::ExitStatus status);

  QString executable_;
  QStringList command_;
  std::unique_ptr<QProcess> process_;
  std::vector<std::unique_ptr<QProcess>> ending_;  ///< were cancelled
  QString said_;                                   ///< lines that are no progress
  QByteArray line_;
};

}  // namespace feedscope::ui
