#pragma once

#include <QList>

#include "ui/runs/run_table.h"
#include "ui/workbench/panel.h"

class QAction;
class QTableView;

namespace feedscope::ui {

/// The runs of the program with their results: chooses the current one, duplicates and changes it, hides,
/// reorders, removes.
class RunsView : public Panel {
  Q_OBJECT

 public:
  /// `runs` outlives this.
  explicit RunsView(RunList& runs, QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  QTableView* table() { return table_; }
  RunTable& results() { return *model_; }
  /// Duplicate, rename, remove, up, down.
  QList<QAction*> panel_actions() const override { return actions_; }
  /// Simulates a cancelled or failed run again.
  QAction* again() { return again_; }
  /// The simulated runs as CSV: columns of comparison_csv, with their names.
  std::string csv() const;

 signals:
  /// Requests another simulation of the run in this row.
  void again_wanted(std::size_t row);
  /// The user has selected the row of a trace.
  void trace_chosen(std::size_t trace);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_actions();
  void add_action(const QString& text, const QString& tip, const QKeySequence& key, void (RunsView::*call)());
  void duplicate();
  void remove();
  void rename();
  void move_up();
  void move_down();
  void choose_colour();
  /// None if a run is selected.
  std::optional<std::size_t> chosen_trace() const;
  void follow_current();
  void follow_status();
  void fit_names();
  void save_csv();

  RunList& runs_;
  TraceList* traces_ = nullptr;
  RunTable* model_;
  QTableView* table_;
  QList<QAction*> actions_;
  QAction* again_ = nullptr;
};

}  // namespace feedscope::ui
