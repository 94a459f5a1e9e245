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

/// Breakdown of the current run's time and helpful changes: a conclusion, then the parts of the cycle time,
/// the places with the largest loss grouped by common properties, simulated changes, causes and operations. A
/// click goes to the place; a change becomes a run.
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
  /// `slowest` is between `from` and `to` [s].
  void place_chosen(double slowest, double from, double to);
  /// The user has chosen a place [s].
  void time_chosen(double time);
  /// Requests a new run with this setup.
  void run_wanted(const feedscope::ui::SetupState& setup);
  /// Requests a report with these contents.
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
