#include "ui/charts/overlay_curves.h"

#include <cmath>
#include <utility>

namespace feedscope::ui {

void OverlayCurves::set_runs(std::vector<RunOverlay> runs) {
  runs_ = std::move(runs);
  columns_.assign(runs_.size(), {});
}

void OverlayCurves::clear() {
  for (ColumnCache& columns : columns_) {
    columns.clear();
  }
}

void OverlayCurves::update(const ViewRange& range, const Trajectory& run, int count) {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    columns_[i].update(*runs_[i].envelope, {range.lower(), range.upper()}, count,
                       [&](double position) { return time_of(runs_[i], range, run, position); });
  }
}

double OverlayCurves::time_of(const RunOverlay& overlay, const ViewRange& range, const Trajectory& run,
                              double position) {
  if (range.abscissa() == Abscissa::time) {
    return position;
  }
  const Trajectory& other = *overlay.trajectory;
  return other.state_at_path(same_place(run.path(), position, other.path())).time;
}

std::vector<OverlayCurve> OverlayCurves::curves(std::size_t chart, const ChartSpec& spec) const {
  std::vector<OverlayCurve> curves;
  if (!chosen_[chart].has_value()) {
    return curves;
  }
  const QuantityId quantity = spec.curves[*chosen_[chart]].quantity;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    OverlayCurve curve{{}, runs_[i].color, runs_[i].dashed};
    for (const Band& band : columns_[i].bands()) {
      curve.columns.push_back(band[quantity]);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<LegendEntry> OverlayCurves::legend(std::size_t chart, const ChartSpec& spec,
                                               const ViewRange& range, const Trajectory* run,
                                               std::optional<double> position) const {
  std::vector<LegendEntry> entries;
  if (!chosen_[chart].has_value()) {
    return entries;
  }
  const QuantityInfo& quantity = info_of(spec.curves[*chosen_[chart]].quantity);
  for (const RunOverlay& overlay : runs_) {
    LegendEntry entry{overlay.name, overlay.color, overlay.dashed, {}};
    if (run != nullptr && position.has_value()) {
      const double time = time_of(overlay, range, *run, *position);
      const State state = overlay.trajectory->state(time);
      InstantSampler sampler(overlay.sources, time);
      const double value = quantity.of(sampler.at(state));
      entry.value = std::isnan(value) ? std::nullopt : std::optional(spec.convert(value));
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace feedscope::ui
