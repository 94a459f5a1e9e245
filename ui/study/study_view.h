#pragma once

#include <QList>

#include "ui/study/study_chart.h"
#include "ui/study/study_job.h"
#include "ui/study/study_table.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/workbench.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace feedscope::ui {

class WholeNumberBox;

class NumberBox;

/// A setting of the current run over a range: cycle time and contour error against it as curves and table,
/// the fastest value within a bound, the limits at both ends; each value can become a run.
class StudyView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit StudyView(Workbench& workbench, QWidget* parent = nullptr);

  /// Simulates the study of the input fields, or reports an error in them.
  void run();
  /// Adds the run of a row of the results, and makes it current.
  void make_run(int row);
  bool busy() const override { return job_.busy(); }

  QComboBox* key() { return key_; }
  NumberBox* from() { return from_; }
  NumberBox* to() { return to_; }
  WholeNumberBox* count() { return count_; }
  StudyChart* chart() { return chart_; }
  QTableView* table() { return table_; }
  QString verdict() const;
  QList<QAction*> panel_actions() const override { return actions_; }

 private:
  void make_fields();
  void make_actions();
  void make_layout();
  void list_keys();
  void propose_range();
  /// Shows the range in the shown unit; both values in the unit of `key`.
  void show_range(double from, double to, const std::string& key);
  void follow_traces();
  void take(std::shared_ptr<const Study> study);
  void forget();
  void forget_results();
  void show_idle();
  QString ends_text() const;

  Workbench& workbench_;
  StudyJob job_;
  std::shared_ptr<const Study> study_;
  SetupState studied_;    ///< setup of the run of study_
  QString studied_name_;  ///< of that run at the time, with its machine
  StudyTable* results_;
  QComboBox* key_;
  NumberBox* from_;
  NumberBox* to_;
  WholeNumberBox* count_;
  QCheckBox* logarithmic_;
  QCheckBox* bounded_;
  NumberBox* bound_;
  QPushButton* run_;
  QPushButton* adopt_;
  QProgressBar* progress_;
  QLabel* verdict_;
  StudyChart* chart_;
  QTableView* table_;
  QList<QAction*> actions_;
};

}  // namespace feedscope::ui
