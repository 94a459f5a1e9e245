#pragma once

#include <QFrame>

#include "ui/models/workbench.h"

class QLabel;
class QToolButton;

namespace feedscope::ui {

/// Says that the current run was cancelled or has failed, so that nothing is shown of it, and offers to
/// simulate it again. Hidden for every other run.
class RunNotice : public QFrame {
  Q_OBJECT

 public:
  /// `model` outlives this.
  explicit RunNotice(Workbench& model, QWidget* parent = nullptr);

  QString text() const;
  QToolButton* again() { return again_; }

 private:
  void follow();

  Workbench& model_;
  QLabel* text_;
  QToolButton* again_;
};

}  // namespace feedscope::ui
