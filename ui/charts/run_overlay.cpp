#include "ui/charts/run_overlay.h"

#include <algorithm>

#include "core/analysis/contour/programmed_place.h"

namespace feedscope::ui {

std::vector<RunOverlay> other_runs(const RunList& runs) {
  std::vector<RunOverlay> others;
  for (std::size_t row = 0; row < runs.items().size(); ++row) {
    const auto result = runs.result(row);
    const RunItem& item = runs.items()[row];
    if (row != runs.current() && item.visible && result != nullptr) {
      others.push_back({result->run.trajectory, result->envelope, result->run.sources, item.colour,
                        runs.lettered_title(row)});
    }
  }
  return others;
}

std::vector<TraceOverlay> shown_traces(const TraceList& traces) {
  std::vector<TraceOverlay> shown;
  for (std::size_t row = 0; row < traces.items().size(); ++row) {
    const TraceItem& item = traces.items()[row];
    if (const auto result = traces.result(row); item.visible && result != nullptr) {
      shown.push_back({result, item.colour, item.name});
    }
  }
  return shown;
}

/// Over time, both start moving together; over path length, they are at the same place.
double TraceOverlay::time_at(const ViewRange& range, double position) const {
  const TraceAlignment& alignment = shown->alignment;
  return range.abscissa() == Abscissa::time ? alignment.at_time(position)
                                            : alignment.at_place(range.time_at(position));
}

std::optional<CuttingFeed> cutting_feed(const Envelope* run, std::span<const Band> shown,
                                        std::span<const RunOverlay> beside) {
  if (run == nullptr || run->cutting()[QuantityId::feed].empty()) {
    return std::nullopt;
  }
  Extent programmed;
  for (const Band& band : shown) {
    programmed.add(band[QuantityId::programmed_feed]);
  }
  if (programmed.min > run->cutting()[QuantityId::programmed_feed].max) {
    return std::nullopt;
  }
  CuttingFeed feed{run->cutting()[QuantityId::feed].max, run->cutting()[QuantityId::programmed_feed].max};
  for (const RunOverlay& overlay : beside) {
    feed.achieved = std::max(feed.achieved, double{overlay.envelope->cutting()[QuantityId::feed].max});
  }
  std::vector<double> columns;  // of this run only: the others cut the same program
  for (const Band& band : shown) {
    const double fastest = band[QuantityId::feed].max;
    columns.push_back(fastest > feed.achieved ? 0 : fastest);  // 0: in a rapid
  }
  if (const double lasts = largest_that_lasts(columns); is_far_beyond(feed.achieved, lasts)) {
    feed.achieved = lasts;
    feed.without_peaks = true;
  }
  return feed;
}

double same_place(const BlendedPath& from, double s, const BlendedPath& to) {
  return from.empty() || to.empty() ? 0 : path_length_of(to, programmed_place(from, s));
}

}  // namespace feedscope::ui
