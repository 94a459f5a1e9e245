#include "ui/charts/overlay_curves.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace feedscope::ui {

void OverlayCurves::set_runs(std::vector<RunOverlay> runs) {
  runs_ = std::move(runs);
  columns_.assign(runs_.size(), {});
}

void OverlayCurves::propose(std::size_t chart, QuantityId quantity) {
  const ChartSpec spec = kinematic_chart_specs()[chart];
  const bool is_known = std::ranges::any_of(
      traces_, [&](const TraceOverlay& trace) { return trace.shown->motion.knows(quantity); });
  const auto found = std::ranges::find(spec.curves, quantity, &CurveSpec::quantity);
  if (is_known && !chosen_[chart].has_value() && found != spec.curves.end()) {
    chosen_[chart] = static_cast<std::size_t>(found - spec.curves.begin());
  }
}

void OverlayCurves::set_traces(std::vector<TraceOverlay> traces) {
  const bool first = traces_.empty();
  traces_ = std::move(traces);
  trace_columns_.assign(traces_.size(), {});
  if (first) {
    propose(acceleration_chart, QuantityId::tangential_acceleration);
    propose(following_error_chart, QuantityId::following_error_x);
  }
}

void OverlayCurves::clear() {
  for (ColumnCache& columns : columns_) {
    columns.clear();
  }
  for (ColumnCache& columns : trace_columns_) {
    columns.clear();
  }
}

double OverlayCurves::end() const {
  double end = 0;
  if (std::ranges::none_of(chosen_, [](const auto& curve) { return curve.has_value(); })) {
    return end;
  }
  for (const RunOverlay& run : runs_) {
    end = std::max(end, run.trajectory->duration());
  }
  for (const TraceOverlay& trace : traces_) {
    end = std::max(end, trace.shown->alignment.end_time());
  }
  return end;
}

void OverlayCurves::update(const ViewRange& range, const Trajectory& run, int count) {
  if (std::exchange(rapids_, range.rapids_shown()) != rapids_) {
    clear();
  }
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    columns_[i].update(
        *runs_[i].envelope, runs_[i].trajectory->duration(), {range.lower(), range.upper()}, count,
        [&](double position) { return time_of(runs_[i], range, run, position); }, rapids_);
  }
  for (std::size_t i = 0; i < traces_.size(); ++i) {
    const TraceMotion& motion = traces_[i].shown->motion;
    trace_columns_[i].update([&](std::span<const double> times) { return motion.columns(times); },
                             {range.lower(), range.upper()}, count,
                             [&](double position) { return traces_[i].time_at(range, position); });
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
  for (std::size_t i = 0; i < traces_.size(); ++i) {
    if (traces_[i].shown->motion.knows(quantity)) {
      OverlayCurve curve{{}, traces_[i].color, false};
      for (const Band& band : trace_columns_[i].bands()) {
        curve.columns.push_back(band[quantity]);
      }
      curves.push_back(std::move(curve));
    }
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
  for (const TraceOverlay& trace : traces_) {
    const TraceMotion& motion = trace.shown->motion;
    if (!motion.knows(quantity.id)) {
      continue;
    }
    LegendEntry entry{trace.name, trace.color, false, {}};
    const double time = position.has_value() ? trace.time_at(range, *position) : MatchedRecord::unmatched;
    if (run != nullptr && !std::isnan(time)) {
      const State state = motion.state(time);
      const std::optional<ActualSample> drives = motion.drives(time);
      entry.value = spec.convert(quantity.of(Instant(state, drives ? &*drives : nullptr)));
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace feedscope::ui
