#pragma once

#include <QWidget>

#include "ui/workbench/run_comparison.h"
#include "ui/workbench/workbench.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace feedscope::ui {

/// The right side of the status bar: progress with cancel, diagnostics, values at the cursor.
class StatusPanel : public QWidget {
  Q_OBJECT

 public:
  /// Both outlive this.
  StatusPanel(Workbench& workbench, RunComparison& comparison, QWidget* parent = nullptr);

  /// Stops reading or simulating; if neither is running, the comparison of runs.
  void cancel();

 signals:
  void diagnostics_clicked();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void keep_height();
  void show_busy();
  void show_activity(const QString& activity, double fraction);
  void show_progress(double fraction);
  void show_comparison();
  void show_cursor();
  void count_diagnostics();

  Workbench& workbench_;
  RunComparison& comparison_;
  QLabel* activity_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  QToolButton* diagnostics_;
  QLabel* cursor_;
};

}  // namespace feedscope::ui
