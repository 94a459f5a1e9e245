#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace feedscope::ui {

/// Makes reports in a process of its own, `feedscope report`: the window goes on, and the bytes are those of
/// the command line. One at a time: another one ends the one under way, of which nothing more is heard.
class ReportProcess : public QObject {
  Q_OBJECT

 public:
  /// `executable`: the program with the command `report`.
  explicit ReportProcess(QString executable, QObject* parent = nullptr);
  ~ReportProcess() override;

  /// `arguments`: behind "report"; `folder`: where relative names of files are.
  void start(const QStringList& arguments, const QString& folder);
  /// No signal follows.
  void cancel();
  bool busy() const { return process_.state() != QProcess::NotRunning; }

 signals:
  void progressed(double fraction);
  void done();
  /// For the user: what the command says of it.
  void failed(const QString& message);

 private:
  void read();
  void end(int code, QProcess::ExitStatus status);

  QString executable_;
  QProcess process_;
  QString said_;  ///< lines that are no progress
  QByteArray line_;
};

}  // namespace feedscope::ui
