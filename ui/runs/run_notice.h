#pragma once

#include <QFrame>

#include "ui/workbench/workbench.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace feedscope::ui {

/// Says why nothing is shown: what is being done and how far it is; the current run was cancelled or has
/// failed, and can be simulated again; the program could not be read, or nothing in it moves. Hidden where
/// there is something to see.
class RunNotice : public QFrame {
  Q_OBJECT

 public:
  /// Lies over the lower edge of `stage`, which keeps its size. `workbench` outlives this.
  RunNotice(Workbench& workbench, QWidget& stage);

  /// To be said while no program is there; empty: nothing.
  void say_without_program(const QString& text);
  QString text() const;
  QToolButton* again() { return again_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void follow();
  /// Whether the current run is on its way.
  bool waits() const;
  QString reason() const;

  Workbench& workbench_;
  QLabel* text_;
  QProgressBar* progress_;
  QString without_program_;
  QString activity_;  ///< what is being done
  QToolButton* again_;
};

}  // namespace feedscope::ui
