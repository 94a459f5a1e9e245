#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "ui/shared/job.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

/// Reference of run `row` among `count` runs: the chosen one; if that is the run itself or none was chosen,
/// the one shown next to it; else the first other one. None if it is alone.
std::optional<std::size_t> reference_row(std::size_t count, std::size_t row,
                                         std::optional<std::size_t> chosen,
                                         std::optional<std::size_t> beside);

/// Comparisons of runs for the 3D view: the reference of each run, and the paths with their differences,
/// computed outside the GUI thread on first request.
class RunComparison : public QObject {
  Q_OBJECT

 public:
  /// `runs` outlives this.
  explicit RunComparison(const RunList& runs, QObject* parent = nullptr);

  /// Sets the reference for all other runs, by its id; 0: none.
  void choose(int id);
  /// Also 0 if the run no longer exists.
  int chosen() const;
  /// The run shown next to the current one, by its id; 0: none.
  void set_beside(int id);

  /// Row of the reference of `row`. The current run and the one next to it are compared with each other,
  /// unless a third was chosen.
  std::optional<std::size_t> reference_of(std::size_t row) const;
  /// The compared path of `row`; null until ready() is emitted, or if it cannot be made.
  std::shared_ptr<const SampledPath> samples(std::size_t row);
  bool busy() const;
  /// Of the running computation, in [0, 1].
  double progress() const;
  /// Cancels the running computation; a request starts it again.
  void cancel();

 signals:
  /// Emitted some times a second while busy, and once afterwards.
  void progressed();
  /// The running computation was cancelled.
  void cancelled();
  /// The reference has changed.
  void reference_changed();
  /// A requested path is ready.
  void ready();

 private:
  struct Pair {
    std::shared_ptr<const ShownRun> run;
    std::shared_ptr<const ShownRun> reference;
    std::shared_ptr<const SampledPath> samples;
    Job<std::shared_ptr<const SampledPath>> job;
  };
  void start(Pair& pair);
  void forget_gone_results();

  const RunList& runs_;
  int chosen_ = 0;
  int beside_ = 0;
  std::vector<std::unique_ptr<Pair>> pairs_;
};

}  // namespace feedscope::ui
