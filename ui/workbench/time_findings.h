#pragma once

#include <QTimer>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ui/workbench/setup_state.h"
#include "ui/workbench/time_job.h"

namespace feedscope::ui {

/// Breakdown of the current run's time and helpful changes, for all panels that show them.
///
/// Computes while one of them is visible. If simulation takes long, changes are tried on request only. For a
/// run that follows another one, they are tried once, after a pause without other simulations.
class TimeFindings : public QObject {
  Q_OBJECT

 public:
  explicit TimeFindings(QObject* parent = nullptr);

  /// The run and its setup; null: none.
  void set_run(std::shared_ptr<const ShownRun> shown, const SetupState& setup);
  /// Whether `viewer` is visible.
  void set_watched(const QObject* viewer, bool seen);
  /// Leaves the processors to another simulation, or resumes interrupted work.
  void give_way(bool to_others);
  /// Simulates changes, however long it takes.
  void try_changes();
  void cancel();
  bool busy() const { return job_.busy() || pause_.isActive(); }

  const std::shared_ptr<const ShownRun>& shown() const { return shown_; }
  /// Whether there is a run with a cycle time that the control does not refuse.
  bool has_time() const;
  /// Null while nothing is known.
  const std::shared_ptr<const TimeReport>& report() const { return report_; }
  /// Whether the changes have been tried.
  bool tried() const { return tried_; }
  /// Whether changes are being simulated.
  bool trying() const { return job_.busy() && report_ != nullptr; }
  bool working() const { return job_.busy(); }
  /// The setup of the run with a change. Throws InputError.
  SetupState changed_by(const Remedy& remedy) const;

 signals:
  /// The run has changed, or more is known about it.
  void changed();
  /// Work has started or ended; `failure`: reason why it failed, for the user.
  void state_changed(const QString& failure);
  void progressed(double fraction);

 private:
  /// Findings on a run shown before.
  struct Known {
    std::weak_ptr<const Trajectory> run;
    std::shared_ptr<const TimeReport> report;
  };

  void catch_up();
  void look();
  /// Tries changes now if requested, nothing else is running and there is something to gain.
  void try_wanted();
  void take(const std::shared_ptr<const TimeReport>& report);
  void remember();
  std::shared_ptr<const TimeReport> recall() const;

  TimeJob job_;
  std::shared_ptr<const ShownRun> shown_;
  std::optional<SetupState> setup_;  ///< of the last run; none before the first
  std::shared_ptr<const TimeReport> report_;
  std::vector<Known> known_;  ///< the newest last
  std::set<const QObject*> viewers_;
  QTimer pause_;            ///< before changes are tried without a request
  bool tried_ = false;      ///< whether the changes have been tried
  bool wanted_ = false;     ///< whether to try the changes
  bool asked_ = false;      ///< whether the user requested it
  bool gives_way_ = false;  ///< whether something else is being simulated
  bool stale_ = false;
};

}  // namespace feedscope::ui
