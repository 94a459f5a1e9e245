#pragma once

#include <QFrame>

#include "ui/models/workbench.h"

class QLabel;
class QToolButton;

namespace feedscope::ui {

/// Says why nothing is shown: the current run was cancelled or has failed, and can be simulated again; the
/// program could not be read, or nothing in it moves. Hidden where there is something to see.
class RunNotice : public QFrame {
  Q_OBJECT

 public:
  /// `model` outlives this.
  explicit RunNotice(Workbench& model, QWidget* parent = nullptr);

  QString text() const;
  QToolButton* again() { return again_; }

 private:
  void follow();
  QString reason() const;

  Workbench& model_;
  QLabel* text_;
  QToolButton* again_;
};

}  // namespace feedscope::ui
