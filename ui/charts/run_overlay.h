#pragma once

#include <QColor>
#include <QString>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/envelope/envelope.h"
#include "ui/charts/value_fit.h"
#include "ui/shared/view_range.h"
#include "ui/workbench/run_list.h"
#include "ui/workbench/trace_list.h"

namespace feedscope::ui {

/// Another run of the same program, drawn with the one of the charts.
struct RunOverlay {
  std::shared_ptr<const Trajectory> trajectory;
  std::shared_ptr<const Envelope> envelope;
  RunSources sources;
  QColor color;
  QString name;
  bool dashed = false;
};

/// The shown and simulated runs of the list, except the current one.
std::vector<RunOverlay> other_runs(const RunList& runs);

/// A recorded trace of the program, drawn with its run.
struct TraceOverlay {
  std::shared_ptr<const ShownTrace> shown;
  QColor color;
  QString name;

  /// Time of the trace at a position of the charts [s]; NaN outside the trace.
  double time_at(const ViewRange& range, double position) const;
};

/// The shown traces of the list that are compared with the current run.
std::vector<TraceOverlay> shown_traces(const TraceList& traces);

/// The largest cutting feeds of a run and of the runs in `beside` [mm/s]; none without a run (null), or if
/// the part in `shown` is rapids alone.
std::optional<CuttingFeed> cutting_feed(const Envelope* run, std::span<const Band> shown,
                                        std::span<const RunOverlay> beside);

/// Path length on `to` of the place at path length `s` on `from`: the same programmed segment, at the same
/// fraction of the executed part of it [mm]. Corner blends shorten each run's path differently, so equal path
/// lengths are different places. For a segment that `to` omitted, its beginning.
double same_place(const BlendedPath& from, double s, const BlendedPath& to);

}  // namespace feedscope::ui
