#include "ui/charts/value_ticks.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "core/base/ticks.h"

namespace feedscope::ui {
namespace {

constexpr double long_number = 1e6;  // too wide for the margin of the plot

}  // namespace

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

QString tick_text(double value, double step, double largest) {
  const QString text = largest >= long_number ? QLocale().toString(value, 'g', 4)
                                              : QLocale().toString(value, 'f', step_decimals(step));
  return text.startsWith('-') ? QChar(0x2212) + text.mid(1) : text;
}

}  // namespace feedscope::ui
