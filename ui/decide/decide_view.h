#pragma once

#include "ui/decide/share_bars.h"
#include "ui/workbench/decision.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/workbench.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace feedscope::ui {

class DecisionChart;
class NumberBox;

/// The run to take: a sentence with the reason, cycle time over contour error with a bound that can be
/// dragged, the runs, where the time of the current run goes and helpful changes. For one run: how much of
/// its time is lost and to which causes, and an offer to compare tolerances.
class DecideView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit DecideView(Workbench& workbench, QWidget* parent = nullptr);

  void set_on_screen(bool on_screen) override;
  QList<QAction*> panel_actions() const override { return {compare_}; }
  /// The command "Compare tolerances...".
  QAction* compare() const { return compare_; }
  /// Adds runs in one step of the history. When all are simulated, the recommended one becomes the current
  /// run, and a cursor at the start moves to its largest contour error.
  void compare_with(const std::vector<SetupState>& setups);

  QString headline() const;
  QString rule() const;
  DecisionChart& chart() { return *chart_; }
  QTreeWidget& table() { return *table_; }
  ShareBars& causes() { return *causes_; }
  /// Buttons of the helpful changes.
  QList<QPushButton*> tries() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void make_layout();
  void make_bound();
  void connect_runs();
  void follow_palette();
  void watch();
  void ask();
  /// Updates everything, once for all changes in a turn of the event loop.
  void refresh();
  void show_all();
  void show_decision();
  void show_chart();
  void show_table();
  void add_row(std::size_t row, std::size_t against, bool taken);
  void show_causes();
  void show_help();
  void set_bound();
  /// Makes the recommended run the current one, once, when all runs of a comparison are simulated.
  void choose_best();
  void go_to_cause(std::size_t row);
  void try_change(const Remedy& remedy);
  /// How many runs are simulated; "" if all are.
  QString progress_text() const;

  Workbench& workbench_;
  RunList& runs_;
  QAction* compare_;
  QString compare_tip_;  ///< while there are runs to compare
  QLabel* headline_;
  QLabel* rule_;
  QPushButton* offer_;
  DecisionChart* chart_;
  QCheckBox* bounded_;
  NumberBox* bound_;
  QTreeWidget* table_;
  QLabel* causes_title_;
  ShareBars* causes_;
  QLabel* help_title_;
  QGridLayout* help_;
  QList<QPushButton*> tries_;
  bool on_screen_ = true;
  bool showing_ = false;  ///< the table is being filled: its changes are not the user's
  bool refreshing_ = false;
  bool choosing_ = false;  ///< choose_best() will follow
};

}  // namespace feedscope::ui
