#pragma once

#include <QFrame>

#include "ui/workbench/workbench.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace feedscope::ui {

/// Explains an empty view: work in progress and its state; a current run that was cancelled or failed, and
/// can be simulated again; a program that cannot be read or does not move. Hidden otherwise.
class RunNotice : public QFrame {
  Q_OBJECT

 public:
  /// Covers the lower edge of `stage`, which keeps its size. `workbench` outlives this.
  RunNotice(Workbench& workbench, QWidget& stage);

  /// Text shown without a program; empty: none.
  void say_without_program(const QString& text);
  QString text() const;
  QToolButton* again() { return again_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void follow();
  /// Whether the current run is being simulated.
  bool waits() const;
  QString reason() const;

  Workbench& workbench_;
  QLabel* text_;
  QProgressBar* progress_;
  QString without_program_;
  QString activity_;  ///< current activity
  QToolButton* again_;
};

}  // namespace feedscope::ui
