#pragma once

#include <QTimer>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ui/workbench/setup_state.h"
#include "ui/workbench/time_job.h"

namespace feedscope::ui {

/// Where the time of the current run goes and what would help, for all panels that show it.
///
/// Works while one of them can be seen. Changes of programs that take long to simulate are tried when asked
/// for; those of a run that follows another one after a pause in which nothing else is simulated, and once.
class TimeFindings : public QObject {
  Q_OBJECT

 public:
  explicit TimeFindings(QObject* parent = nullptr);

  /// The run, and the setup that it was made with; null: none.
  void set_run(std::shared_ptr<const ShownRun> shown, const SetupState& setup);
  /// Whether `viewer` can be seen.
  void set_watched(const QObject* viewer, bool seen);
  /// Leaves the processors to another simulation, or takes up what that has interrupted.
  void give_way(bool to_others);
  /// Simulates what would help, however long it takes.
  void try_changes();
  void cancel();
  bool busy() const { return job_.busy() || pause_.isActive(); }

  const std::shared_ptr<const ShownRun>& shown() const { return shown_; }
  /// Whether there is a run that takes time and that the control does not refuse.
  bool has_time() const;
  /// Null while nothing is known.
  const std::shared_ptr<const TimeReport>& report() const { return report_; }
  /// What would help is known.
  bool tried() const { return tried_; }
  /// What would help is being simulated.
  bool trying() const { return job_.busy() && report_ != nullptr; }
  bool working() const { return job_.busy(); }
  /// The setup of the run with a change. Throws InputError.
  SetupState changed_by(const Remedy& remedy) const;

 signals:
  /// Another run, or more is known of it.
  void changed();
  /// Work has begun or ended; `failure` says why in vain, for the user.
  void state_changed(const QString& failure);
  void progressed(double fraction);

 private:
  /// What is known of a run that was shown before.
  struct Known {
    std::weak_ptr<const Trajectory> run;
    std::shared_ptr<const TimeReport> report;
  };

  void catch_up();
  void look();
  /// Tries changes now if that is wanted, nothing else is under way and there is something to gain.
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
  QTimer pause_;            ///< before changes are tried unasked
  bool tried_ = false;      ///< what would help is known
  bool wanted_ = false;     ///< what would help is to be tried
  bool asked_ = false;      ///< by the user
  bool gives_way_ = false;  ///< something else is simulated
  bool stale_ = false;
};

}  // namespace feedscope::ui
