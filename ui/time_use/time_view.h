#pragma once

#include <QTimer>

#include "ui/time_use/time_job.h"
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
///
/// Works while it can be seen. Changes of programs that take long to simulate are tried when asked for; those
/// of a run that follows another one after a pause in which nothing else is simulated, and once.
class TimeView : public Panel {
  Q_OBJECT

 public:
  explicit TimeView(QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  /// The run, and the setup that it was made with; null: none.
  void set_run(std::shared_ptr<const ShownRun> shown, const SetupState& setup);
  void set_on_screen(bool on_screen) override;
  bool busy() const override { return job_.busy() || pause_.isActive(); }
  QList<QAction*> panel_actions() const override { return actions_; }
  /// Simulates what would help, however long it takes.
  void try_changes();
  void cancel();

  /// Null while nothing is known.
  const std::shared_ptr<const TimeReport>& report() const { return report_; }
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

 private:
  bool is_seen() const { return on_screen_ && isVisible(); }
  /// Whether there is a run, and the control does not refuse it.
  bool has_time() const;
  /// What is known of a run that was shown before.
  struct Known {
    std::weak_ptr<const Trajectory> run;
    std::shared_ptr<const TimeReport> report;
  };

  void catch_up();
  void look();
  /// Tries changes now if that is wanted, nothing else is under way and there is something to gain.
  void try_wanted();
  /// Leaves the processors to another simulation, or takes up what it has interrupted.
  void give_way(bool to_others);
  void take(const std::shared_ptr<const TimeReport>& report);
  void remember(const std::shared_ptr<const TimeReport>& report);
  std::shared_ptr<const TimeReport> recall() const;
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
  TimeJob job_;
  std::shared_ptr<const ShownRun> shown_;
  std::optional<SetupState> setup_;
  std::shared_ptr<const TimeReport> report_;
  std::vector<TimeSection> sections_;
  std::vector<Known> known_;  ///< the newest last
  QTimer pause_;              ///< before changes are tried unasked
  bool tried_ = false;        ///< what would help is known
  bool wanted_ = false;       ///< what would help is to be tried
  bool asked_ = false;        ///< by the user
  bool gives_way_ = false;    ///< something else is simulated
  bool stale_ = false;
  bool on_screen_ = true;
};

}  // namespace feedscope::ui
