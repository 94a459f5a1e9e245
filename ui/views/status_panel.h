#pragma once

#include <QWidget>

#include "ui/models/workbench.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace feedscope::ui {

/// The right side of the status bar: progress with cancel, diagnostics, what holds at the cursor.
class StatusPanel : public QWidget {
  Q_OBJECT

 public:
  /// `model` outlives this.
  explicit StatusPanel(Workbench& model, QWidget* parent = nullptr);

 signals:
  void diagnostics_clicked();

 private:
  void show_busy(bool busy);
  void show_cursor();
  void count_diagnostics();
  static QString cause_text(const State& state);

  Workbench& model_;
  QLabel* activity_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  QToolButton* diagnostics_;
  QLabel* cursor_;
};

}  // namespace feedscope::ui
