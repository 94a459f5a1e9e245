#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/analysis/envelope/envelope.h"
#include "ui/charts/column_cache.h"
#include "ui/shared/view_range.h"

namespace feedscope::ui {

/// The visible range of a run in the charts: its pixel columns, and the cause that limits the feed in each.
class ChartColumns {
 public:
  void set_run(std::shared_ptr<const Trajectory> trajectory, std::shared_ptr<const Envelope> envelope);
  /// Discards all columns, after a change of the abscissa or of showing rapids.
  void clear() { cache_.clear(); }
  /// Updates to `count` columns over the range.
  void update(const ViewRange& range, int count);

  const std::shared_ptr<const Trajectory>& trajectory() const { return trajectory_; }
  /// Null without a run.
  const Envelope* envelope() const { return envelope_.get(); }
  /// Of the column borders [s]; empty without a run.
  const std::vector<double>& times() const { return cache_.times(); }
  const std::vector<Band>& bands() const { return cache_.bands(); }
  /// Path length over time of the shown part of each column [mm/s]; NaN if nothing is shown.
  std::vector<float> means() const;
  /// The cause that takes most of the time of each column.
  std::vector<std::optional<CauseKind>> dominating() const;
  /// Times of all causes in the visible range [s].
  std::vector<double> causes() const;
  /// Whether a column contains so many pieces of motion that its extremes are not informative.
  bool crowded() const;

 private:
  std::vector<ColumnStretch> shown_stretches() const;

  std::shared_ptr<const Trajectory> trajectory_;
  std::shared_ptr<const Envelope> envelope_;
  ColumnCache cache_;
  bool rapids_ = true;
};

}  // namespace feedscope::ui
