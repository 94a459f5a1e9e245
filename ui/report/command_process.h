#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

namespace feedscope::ui {

/// Runs a command of the command line, such as `feedscope report`, in a separate process: the window remains
/// usable, and the bytes are those of the command line. One at a time: a new one cancels the running one,
/// which emits no more signals. A cancelled command removes its partial files; only the destructor waits for
/// that.
class CommandProcess : public QObject {
  Q_OBJECT

 public:
  /// `executable`: the program; `command`: its first arguments.
  CommandProcess(QString executable, QStringList command, QObject* parent = nullptr);
  ~CommandProcess() override;

  /// `arguments`: after those of the command; `folder`: base of relative file names.
  void start(const QStringList& arguments, const QString& folder);
  /// No signal follows.
  void cancel();
  bool busy() const { return process_ != nullptr && process_->state() != QProcess::NotRunning; }

 signals:
  void progressed(double fraction);
  void done();
  /// The command's message, for the user.
  void failed(const QString& message);

 private:
  void read();
  void forget(const QProcess* ended);
  void end(int code, QProcess::ExitStatus status);

  QString executable_;
  QStringList command_;
  std::unique_ptr<QProcess> process_;
  std::vector<std::unique_ptr<QProcess>> ending_;  ///< cancelled, not ended yet
  QString said_;                                   ///< lines without progress
  QByteArray line_;
};

}  // namespace feedscope::ui
