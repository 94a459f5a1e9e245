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

  /// Inserts commands before the machine.
  void insert_first(const QList<QAction*>& actions);
  /// Adds after the tolerance: whether changes apply to all runs, the comparing command, and at the end the
  /// output commands.
  void add_last(QAction* for_all, QAction* compare, const QList<QAction*>& output);

 signals:
  void machine_file_wanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void choose_machine();
  void add_field(const QString& label, QWidget* field);
  /// Hides the labels in a narrow window, whose room the commands need.
  void fit_in();
  void list_machines();
  void show_setup();
  void show_tolerance();
  void set_tolerance(double tolerance);

  Workbench& workbench_;
  QComboBox* machine_;
  QComboBox* control_model_;
  NumberBox* tolerance_;
  QList<QAction*> labels_;
};

}  // namespace feedscope::ui
