#include "ui/charts/value_ticks.h"

#include <QString>
#include <algorithm>
#include <cmath>

#include "core/base/ticks.h"

namespace feedscope::ui {
namespace {

constexpr double long_number = 1e6;  // too wide for the margin of the plot

/// A round step with two to `most` ticks; where they would be less than `closest` apart and lose labels, the
/// step between the two farthest apart.
double tick_step(const Interval& range, int most, double closest) {
  const auto has_two = [&range](double step) {
    return std::floor(range.upper / step) - std::ceil(range.lower / step) >= 1;
  };
  double step = round_up_125(range.width() / most);
  if (has_two(step)) {
    return step;
  }
  while (!has_two(step)) {
    step = round_up_125(step * 0.3);
  }
  return step < closest ? step_of_two(range.lower, range.upper) : step;
}

}  // namespace

void show_range(QValueAxis* axis, const Interval& range, int most, double closest) {
  const double step = tick_step(range, most, closest);
  if (std::max(std::abs(range.lower), std::abs(range.upper)) >= long_number) {
    axis->setLabelFormat(QStringLiteral("%.4g"));
  } else {
    axis->setLabelFormat(QStringLiteral("%.%1f").arg(step_decimals(step)));
  }
  axis->setTickInterval(step);
  constexpr double nudge = 1e-9;  // of a step: rounding must not turn 0 into "-0.0"
  axis->setTickAnchor(nudge * step);
  axis->setRange(range.lower, range.upper);
}

}  // namespace feedscope::ui
