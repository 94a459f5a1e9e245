#include "ui/charts/chart_rows.h"

#include <QMainWindow>
#include <algorithm>
#include <cmath>

#include "ui/theme/type_size.h"

namespace feedscope::ui {

bool ChartRows::has(const Envelope* envelope, std::size_t chart) const {
  const QuantitySource source = charts[chart]->spec().source;
  return envelope != nullptr ? envelope->has(source) : source == QuantitySource::motion;
}

void ChartRows::show(const Envelope* envelope, const QString& abscissa, QVBoxLayout& layout) const {
  std::size_t last = 0;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const bool shown = has(envelope, i) && !hidden[i];
    charts[i]->setVisible(shown);
    last = shown ? i : last;
  }
  for (std::size_t i = 0; i < charts.size(); ++i) {
    charts[i]->label_abscissa(i == last ? abscissa : QString());
    layout.setStretchFactor(charts[i], i == last ? stretch + 1 : stretch);
  }
}

void ChartRows::show_columns(const ChartColumns& columns, const OverlayCurves& overlays) const {
  const bool none = columns.times().empty();
  charts.front()->set_means(columns.means());
  for (std::size_t i = 0; i < charts.size(); ++i) {
    charts[i]->show_bands(columns.bands(),
                          none ? std::vector<OverlayCurve>() : overlays.curves(i, charts[i]->spec()));
  }
  lost->show_runs(none ? nullptr : columns.trajectory(), overlays.runs(), columns.times());
  shares->update();
  show_notes();
}

void ChartRows::show_usual(const UsualMotion& usual) const {
  for (KinematicChart* chart : charts) {
    chart->set_usual(usual.ranges, UsualCurves::columns_a_stretch);
  }
  shares->set_feeds(usual.feeds);
  show_notes();
}

void ChartRows::give_shares_room(QLayout& layout, int width) const {
  const int charts_alone = layout.minimumSize().width() - layout.contentsMargins().right();
  const int enough = type_pixels(1000);  // [px] width that the charts keep
  const bool fits =
      !shares->is_empty() && charts_alone + FeedShares::usual_width() <= width && width >= enough;
  layout.setContentsMargins(0, 0, fits ? FeedShares::usual_width() : 0, 0);
  shares->setVisible(fits);
  place_shares();
}

void ChartRows::show_notes() const {
  for (std::size_t i = 0; i < charts.size(); ++i) {
    headers[i]->set_notes(charts[i]->limits_in_sight(), charts[i]->notes());
  }
}

void ChartRows::place_shares() const {
  const QRect chart = charts.front()->geometry();
  shares->setGeometry(chart.right() + 1, chart.top(), FeedShares::usual_width(), chart.height());
}

void ChartRows::show_values(const State* state, const RunSources& sources) const {
  std::optional<InstantSampler> sampler;
  std::optional<Instant> instant;
  if (state != nullptr) {
    sampler.emplace(sources, state->time);
    instant.emplace(sampler->at(*state));
  }
  for (ChartHeader* header : headers) {
    header->show_values(instant);
  }
}

void ChartRows::add_to(ChartsState& state) const {
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const std::vector<CurveSpec>& curves = charts[i]->spec().curves;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      if (charts[i]->curve_shown(k) == curves[k].on_demand) {
        (curves[k].on_demand ? state.shown : state.hidden).append(curves[k].key);
      }
    }
    const ChartSpec& spec = charts[i]->spec();
    if (hidden[i] != spec.on_demand) {
      (spec.on_demand ? state.shown_charts : state.hidden_charts).append(spec.key);
    }
  }
  state.values = chosen_values();
}

std::array<std::optional<Interval>, chart_count> ChartRows::chosen_values() const {
  std::array<std::optional<Interval>, chart_count> values;
  std::ranges::transform(charts, values.begin(), &KinematicChart::chosen_values);
  return values;
}

void ChartRows::choose_values(const std::array<std::optional<Interval>, chart_count>& values) const {
  for (std::size_t i = 0; i < charts.size(); ++i) {
    charts[i]->choose_values(values[i]);
  }
}

QSize ChartRows::least_size(const QWidget& content) const {
  constexpr int low = 600;  // [px]: in a lower window, three charts would take the room of the 3D view
  const double scale = TypeSize::of_application().scale();
  const auto* window = qobject_cast<const QMainWindow*>(content.window());
  const bool is_low = window != nullptr && window->height() < low;
  const int most = std::max(2, static_cast<int>(std::lround((is_low ? 2 : 3) / scale)));
  QSize size = content.minimumSizeHint();
  size.rwidth() -= content.layout()->contentsMargins().right();  // give_shares_room() sets it again
  int shown = 0;
  for (const KinematicChart* chart : charts) {
    shown += chart->isVisibleTo(&content) ? 1 : 0;
  }
  if (shown > most) {
    size.setHeight(size.height() * most / shown);
  }
  return size;
}

void ChartRows::draw(QPainter& painter, const QWidget& content) const {
  for (std::size_t i = 0; i < charts.size(); ++i) {
    draw_part(painter, content, *charts[i], [&] { charts[i]->draw(painter); });
    draw_part(painter, content, *headers[i], [&] { headers[i]->draw(painter); });
  }
  draw_part(painter, content, *shares, [&] { shares->draw(painter); });
  draw_part(painter, content, *lost, [&] { lost->draw(painter); });
}

void ChartRows::set_limits(const AxisVector<AxisLimits>& limits, bool of_jerk) const {
  const std::array<double AxisLimits::*, 3> kinds{&AxisLimits::velocity, &AxisLimits::acceleration,
                                                  &AxisLimits::jerk};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    charts[k]->set_limits(k == jerk_chart && !of_jerk ? std::vector<LimitLine>()
                                                      : limit_lines(charts[k]->spec(), limits, kinds[k]));
  }
}

void ChartRows::set_rotary_limits(const MachineKinematics& kinematics) const {
  const auto set = [&](std::size_t i, double RotaryAxis::*kind) {
    charts[i]->set_limits(rotary_limit_lines(charts[i]->spec(), kinematics, kind));
  };
  set(rotary_velocity_chart, &RotaryAxis::velocity);
  set(rotary_acceleration_chart, &RotaryAxis::acceleration);
  set(rotary_jerk_chart, &RotaryAxis::jerk);
}

void ChartRows::set_sources(const RunSources& sources) const {
  for (std::size_t i = 0; i < charts.size(); ++i) {
    std::vector<bool> available;
    for (const CurveSpec& curve : charts[i]->spec().curves) {
      const QuantityInfo& quantity = info_of(curve.quantity);
      const bool of_chart = quantity.source == charts[i]->spec().source;
      available.push_back((of_chart && !sources.has(quantity.source)) || sources.has(quantity));
    }
    headers[i]->set_available(std::move(available));
  }
}

void ChartRows::set_bounds(const RunLoad* load) const {
  for (const std::size_t chart : {force_chart, chip_chart}) {
    charts[chart]->set_limits(load != nullptr ? bound_lines(charts[chart]->spec(), *load)
                                              : std::vector<LimitLine>());
  }
}

}  // namespace feedscope::ui
