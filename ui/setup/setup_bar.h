#pragma once

#include <QToolBar>

#include "ui/workbench/workbench.h"

class QComboBox;

namespace feedscope::ui {

class NumberBox;

/// Machine, control model and contour tolerance of the run.
class SetupBar : public QToolBar {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit SetupBar(Workbench& workbench, QWidget* parent = nullptr);

 private:
  void list_machines();
  void show_setup();
  void show_tolerance();
  void set_tolerance(double tolerance);

  Workbench& workbench_;
  QComboBox* machine_;
  QComboBox* control_model_;
  NumberBox* tolerance_;
};

}  // namespace feedscope::ui
