#include "ui/charts/value_ticks.h"

#include <QLocale>
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
  axis->setTickInterval(step);
  axis->setRange(range.lower, range.upper);
}

QString tick_text(const QValueAxis& axis, double value) {
  const bool is_long = axis.alignment() == Qt::AlignLeft &&
                       std::max(std::abs(axis.min()), std::abs(axis.max())) >= long_number;
  const QString text = is_long ? QLocale().toString(value, 'g', 4)
                               : QLocale().toString(value, 'f', step_decimals(axis.tickInterval()));
  return text.startsWith('-') ? QChar(0x2212) + text.mid(1) : text;
}

}  // namespace feedscope::ui
