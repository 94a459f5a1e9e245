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

/// Another run of the same program, drawn beside the one that the charts show.
struct RunOverlay {
  std::shared_ptr<const Trajectory> trajectory;
  std::shared_ptr<const Envelope> envelope;
  RunSources sources;
  QColor color;
  QString name;
  bool dashed = false;
};

/// Those of the list that are shown and simulated, but for the current one.
std::vector<RunOverlay> other_runs(const RunList& runs);

/// What a control recorded of the program, drawn beside its run.
struct TraceOverlay {
  std::shared_ptr<const ShownTrace> shown;
  QColor color;
  QString name;

  /// Which instant of the trace stands at a position of the charts; not a number where none does [s].
  double time_at(const ViewRange& range, double position) const;
};

/// Those of the list that are shown and compared with the current run.
std::vector<TraceOverlay> shown_traces(const TraceList& traces);

/// The largest feeds that a run and those beside it cut at [mm/s]; none without a run (null), and where what
/// is `shown` of it are rapids alone.
std::optional<CuttingFeed> cutting_feed(const Envelope* run, std::span<const Band> shown,
                                        std::span<const RunOverlay> beside);

/// Path length on `to` of the place that lies at path length `s` on `from`: in the same programmed segment,
/// at the same share of what each run executes of it [mm]. Corner blends shorten every run's path by
/// something else, so equal path lengths are other places. A segment that `to` omitted gives its beginning.
double same_place(const BlendedPath& from, double s, const BlendedPath& to);

}  // namespace feedscope::ui
