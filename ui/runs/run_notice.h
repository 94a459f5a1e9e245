#pragma once

#include <QFrame>

#include "ui/workbench/workbench.h"

class QLabel;
class QToolButton;

namespace feedscope::ui {

/// Says why nothing is shown: the current run was cancelled or has failed, and can be simulated again; the
/// program could not be read, or nothing in it moves. Hidden where there is something to see.
class RunNotice : public QFrame {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit RunNotice(Workbench& workbench, QWidget* parent = nullptr);

  QString text() const;
  QToolButton* again() { return again_; }

 private:
  void follow();
  QString reason() const;

  Workbench& workbench_;
  QLabel* text_;
  QToolButton* again_;
};

}  // namespace feedscope::ui
