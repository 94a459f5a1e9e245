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

/// The other runs in the charts: which of their curves each chart shows, and its columns. Over time they
/// stand by time, over path length by place.
class OverlayCurves {
 public:
  void set_runs(std::vector<RunOverlay> runs);
  const std::vector<RunOverlay>& runs() const { return runs_; }
  /// Drawn as runs are, but only in charts of quantities that a trace has. With the first one the charts of
  /// acceleration and following error show what it knows of them too, unless another curve was chosen.
  void set_traces(std::vector<TraceOverlay> traces);
  const std::vector<TraceOverlay>& traces() const { return traces_; }
  /// The curve of a chart's spec that the other runs show in it; none: no curve. At first the achieved feed
  /// alone.
  void choose(std::size_t chart, std::optional<std::size_t> curve) { chosen_[chart] = curve; }
  std::optional<std::size_t> chosen(std::size_t chart) const { return chosen_[chart]; }

  /// When the last one ends that has a curve in the charts, over time [s].
  double end() const;

  /// Another run or abscissa: all columns are to be found again.
  void clear();
  /// Brings `count` columns over the range up to date; `run` is the one that the range belongs to.
  void update(const ViewRange& range, const Trajectory& run, int count);
  /// Of the chart with this number and spec.
  std::vector<OverlayCurve> curves(std::size_t chart, const ChartSpec& spec) const;
  /// Names of the runs in a chart, and their values where `run` is at `position`; none: without values.
  std::vector<LegendEntry> legend(std::size_t chart, const ChartSpec& spec, const ViewRange& range,
                                  const Trajectory* run, std::optional<double> position) const;

 private:
  void propose(std::size_t chart, QuantityId quantity);
  static double time_of(const RunOverlay& overlay, const ViewRange& range, const Trajectory& run,
                        double position);

  std::vector<RunOverlay> runs_;
  std::vector<ColumnCache> columns_;  ///< one a run
  bool rapids_ = true;                ///< are in them
  std::vector<TraceOverlay> traces_;
  std::vector<ColumnCache> trace_columns_;  ///< one a trace
  std::array<std::optional<std::size_t>, chart_count> chosen_{0};
};

}  // namespace feedscope::ui
