#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "ui/charts/chart_header.h"
#include "ui/charts/column_cache.h"
#include "ui/charts/kinematic_chart.h"
#include "ui/charts/run_overlay.h"
#include "ui/shared/view_range.h"

namespace feedscope::ui {

/// The other runs in the charts: the curves shown for them, and their columns. They are aligned by time over
/// time, and by place over path length.
class OverlayCurves {
 public:
  void set_runs(std::vector<RunOverlay> runs);
  const std::vector<RunOverlay>& runs() const { return runs_; }
  /// Draws traces like runs, but only in charts of their quantities. With the first trace, the charts of
  /// acceleration and following error also show its curves, unless another curve was chosen.
  void set_traces(std::vector<TraceOverlay> traces);
  const std::vector<TraceOverlay>& traces() const { return traces_; }
  /// Index in a chart's spec of the curve shown for other runs; none: no curve. Initially the achieved feed
  /// only.
  void choose(std::size_t chart, std::optional<std::size_t> curve) { chosen_[chart] = curve; }
  std::optional<std::size_t> chosen(std::size_t chart) const { return chosen_[chart]; }

  /// End of the last curve in the charts, over time [s].
  double end() const;

  /// Discards all columns: for another run or abscissa.
  void clear();
  /// Updates to `count` columns over the range, which belongs to `run`.
  void update(const ViewRange& range, const Trajectory& run, int count);
  /// Curves for the chart with this number and spec.
  std::vector<OverlayCurve> curves(std::size_t chart, const ChartSpec& spec) const;
  /// Names of the runs in a chart, and their values where `run` is at `position`; none: without values.
  std::vector<LegendEntry> legend(std::size_t chart, const ChartSpec& spec, const ViewRange& range,
                                  const Trajectory* run, std::optional<double> position) const;

 private:
  void propose(std::size_t chart, QuantityId quantity);
  static double time_of(const RunOverlay& overlay, const ViewRange& range, const Trajectory& run,
                        double position);

  std::vector<RunOverlay> runs_;
  std::vector<ColumnCache> columns_;  ///< one for each run
  bool rapids_ = true;                ///< whether the columns include them
  std::vector<TraceOverlay> traces_;
  std::vector<ColumnCache> trace_columns_;  ///< one for each trace
  std::array<std::optional<std::size_t>, chart_count> chosen_{0};
};

}  // namespace feedscope::ui
