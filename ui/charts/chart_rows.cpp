#include "ui/charts/chart_rows.h"

namespace feedscope::ui {

void ChartRows::show(const Envelope* envelope, const QString& abscissa, QVBoxLayout& layout) const {
  std::size_t last = 0;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const QuantitySource source = charts[i]->spec().source;
    const bool has = source == QuantitySource::motion || (envelope != nullptr && envelope->has(source));
    charts[i]->setVisible(has);
    headers[i]->setVisible(has);
    last = has ? i : last;
  }
  for (std::size_t i = 0; i < charts.size(); ++i) {
    charts[i]->label_abscissa(i == last ? abscissa : QString());
    layout.setStretchFactor(charts[i], i == last ? stretch + 1 : stretch);
  }
}

void ChartRows::show_values(const State* state, const ActualPath* actual) const {
  std::optional<ActualSample> sample;
  if (state != nullptr && actual != nullptr) {
    sample = actual->at(*state);
  }
  for (ChartHeader* header : headers) {
    header->show_values(state != nullptr ? std::optional(Instant(*state, sample ? &*sample : nullptr))
                                         : std::nullopt);
  }
}

void ChartRows::set_limits(const AxisVector<AxisLimits>& limits) const {
  const std::array<double AxisLimits::*, 3> kinds{&AxisLimits::velocity, &AxisLimits::acceleration,
                                                  &AxisLimits::jerk};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    charts[k]->set_limits(limit_lines(charts[k]->spec(), limits, kinds[k]));
  }
}

}  // namespace feedscope::ui
