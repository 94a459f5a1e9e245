#pragma once

#include <QTimer>

#include "ui/time_use/time_rows.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/setup_state.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace feedscope::ui {

/// Where the time of the current run goes and what would help: a conclusion, then what the cycle time
/// consists of, the places that lose most by what they have in common, changes that were simulated, causes
/// and operations. A click goes to the place; a change becomes a run.
class TimeView : public Panel {
  Q_OBJECT

 public:
  /// `findings` outlives this.
  explicit TimeView(TimeFindings& findings, QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  void set_on_screen(bool on_screen) override;
  bool busy() const override { return findings_.busy(); }
  QList<QAction*> panel_actions() const override { return actions_; }

  QTreeWidget& tree() { return *tree_; }
  QString conclusion() const;

 signals:
  /// `slowest` lies between `from` and `to` [s].
  void place_chosen(double slowest, double from, double to);
  /// A place that has been chosen [s].
  void time_chosen(double time);
  /// A run with this setup is wanted beside the current one.
  void run_wanted(const feedscope::ui::SetupState& setup);
  /// What is said here is wanted on paper.
  void report_wanted();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void watch();
  void show_sections();
  void add_rows(QTreeWidgetItem* parent, const std::vector<TimeRow>& rows);
  void show_state(const QString& failure);
  void show_actions();
  void choose(const QTreeWidgetItem* item);
  void want_run();
  const TimeRow* chosen_row() const;

  QLabel* conclusion_;
  QTreeWidget* tree_;
  QLabel* state_;
  QProgressBar* progress_;
  QPushButton* try_;
  QPushButton* new_run_;
  QPushButton* paper_;
  QAction* try_action_ = nullptr;
  QAction* run_action_ = nullptr;
  QList<QAction*> actions_;
  TimeFindings& findings_;
  std::vector<TimeSection> sections_;
  bool on_screen_ = true;
};

}  // namespace feedscope::ui
