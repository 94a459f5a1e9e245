#pragma once

#include <QList>
#include <memory>
#include <optional>

#include "ui/circular/circular_job.h"
#include "ui/circular/circular_state.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/workbench.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSplitter;
class QTableView;

namespace feedscope::ui {

class CircularTable;
class NumberBox;
class NumberListField;
class PolarPlot;

/// Circular tests (ISO 230-4) on the machine and control of the current run, of circles of several radii and
/// feeds, or of the full circles of the program: a table of the values, and a polar plot of the selected row.
/// A test is discarded when machine or control change; circles of the program follow the current run while
/// the panel is visible.
class CircularView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit CircularView(Workbench& workbench, QWidget* parent = nullptr);

  /// Simulates the circles of the input fields, or reports an error in them.
  void run();
  /// The shown test and its drawn circle; none: nothing, or circles of the program.
  std::optional<CircularShown> shown() const;
  /// Shows a test of the current setup again, as returned by shown().
  void show_again(CircularShown shown);
  CircularState state() const;
  void set_state(const CircularState& state);
  bool busy() const override { return job_.busy(); }
  void set_on_screen(bool on_screen) override;
  QList<QAction*> panel_actions() const override { return actions_; }

  QComboBox* source() { return source_; }
  NumberListField* radii() { return radii_; }
  NumberListField* feeds() { return feeds_; }
  QCheckBox* with_entry() { return with_entry_; }
  NumberBox* entry() { return entry_; }
  QComboBox* plane() { return plane_; }
  QTableView* list() { return list_; }
  CircularTable* table() { return table_; }
  PolarPlot* plot() { return plot_; }
  /// The message of the panel: on the result, or an error.
  QString message() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool of_program() const;
  void make_fields();
  void make_list();
  void make_actions();
  void make_layout();
  void change_source();
  void evaluate_program();
  void take(const JobOutcome<CircularResult>& outcome);
  void show_selected();
  void forget();
  void show_idle(const QString& message);
  QString nothing_yet() const;
  void save_picture();
  void save_table();

  Workbench& workbench_;
  CircularJob job_;
  QComboBox* source_;
  QWidget* fields_;
  NumberListField* radii_;
  NumberListField* feeds_;
  QCheckBox* with_entry_;
  NumberBox* entry_;
  QComboBox* plane_;
  QPushButton* run_;
  QLabel* message_;
  QSplitter* results_;
  CircularTable* table_;
  QTableView* list_;
  PolarPlot* plot_;
  QList<QAction*> actions_;
  std::optional<CircularResult> result_;     ///< shown
  std::weak_ptr<const ShownRun> evaluated_;  ///< run whose circles are shown or being evaluated
  bool on_screen_ = true;
};

}  // namespace feedscope::ui
