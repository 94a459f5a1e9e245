#pragma once

#include <QList>

#include "core/analysis/circularity/circular_test.h"
#include "ui/shared/job.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/workbench.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace feedscope::ui {

class NumberBox;
class PolarPlot;

/// A circular test (ISO 230-4) on the machine and control of the current run: fields for the circle, a polar
/// plot of both directions and its values. What is shown is forgotten as soon as machine or control change.
class CircularView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit CircularView(Workbench& workbench, QWidget* parent = nullptr);

  /// Simulates the circle that the fields describe, or says what is wrong with them.
  void run();
  bool busy() const override { return job_.busy(); }
  QList<QAction*> panel_actions() const override { return actions_; }

  NumberBox* radius() { return radius_; }
  NumberBox* feed() { return feed_; }
  QCheckBox* with_entry() { return with_entry_; }
  NumberBox* entry() { return entry_; }
  QComboBox* plane() { return plane_; }
  PolarPlot* plot() { return plot_; }
  /// What the panel says: of the result, or what is wrong.
  QString message() const;

 private:
  void make_fields();
  void make_actions();
  void make_layout();
  CircularRequest request() const;
  void take(const CircularTest& test);
  void forget();
  void show_idle(const QString& message);
  void save_picture();

  Workbench& workbench_;
  Job<CircularTest> job_;
  NumberBox* radius_;
  NumberBox* feed_;
  QCheckBox* with_entry_;
  NumberBox* entry_;
  QComboBox* plane_;
  QPushButton* run_;
  QLabel* message_;
  PolarPlot* plot_;
  QList<QAction*> actions_;
};

}  // namespace feedscope::ui
