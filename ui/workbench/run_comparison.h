#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "ui/shared/job.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

/// Which of `count` runs run `row` is compared with: the one that was chosen; where that is the run itself or
/// none was chosen, the one shown beside it; else the first other one. None if it is alone.
std::optional<std::size_t> reference_row(std::size_t count, std::size_t row,
                                         std::optional<std::size_t> chosen,
                                         std::optional<std::size_t> beside);

/// The runs compared with each other for the 3D view: which one with which, and the paths with their
/// differences, made off the GUI thread when first asked for.
class RunComparison : public QObject {
  Q_OBJECT

 public:
  /// `runs` outlives this.
  explicit RunComparison(const RunList& runs, QObject* parent = nullptr);

  /// The run that all others are compared with, by its id; 0: none in particular.
  void choose(int id);
  /// 0 too where the run is gone.
  int chosen() const;
  /// The run that stands beside the current one, by its id; 0: none.
  void set_beside(int id);

  /// Row that `row` is compared with; the run beside the current one and the current one with each other,
  /// unless a third was chosen.
  std::optional<std::size_t> reference_of(std::size_t row) const;
  /// The path of `row` compared; null until it is there, which ready() says, or if it cannot be made.
  std::shared_ptr<const SampledPath> samples(std::size_t row);
  bool busy() const;
  /// Of what is being made, in [0, 1].
  double progress() const;
  /// Gives up what is being made; asking for it starts it again.
  void cancel();

 signals:
  /// While busy, some times a second; and once when it is not any more.
  void progressed();
  /// What was being made was given up.
  void cancelled();
  /// Another run is compared with.
  void reference_changed();
  /// A path that was asked for is there.
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
