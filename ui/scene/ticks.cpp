#include "ui/scene/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace feedscope::ui {

double round_up_125(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  constexpr double slack = 1 + 1e-9;  // 0.1 * 10 must count as 1
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (step <= factor * power * slack) {
      return factor * power;
    }
  }
  return 10 * power;
}

Ticks round_ticks(double minimum, double maximum, int most) {
  Ticks ticks;
  const double range = maximum - minimum;
  if (!(range > 0) || !std::isfinite(range) || most < 1) {
    return ticks;
  }
  const double slack = 1e-9 * range;
  for (double step = round_up_125(range / most);; step = round_up_125(step * 1.5)) {
    const double first = std::ceil((minimum - slack) / step);
    const double last = std::floor((maximum + slack) / step);
    if (last - first + 1 > most) {
      continue;
    }
    ticks.step = step;
    const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 12);
    for (double k = first; k <= last; ++k) {
      const double value = k == 0 ? 0.0 : k * step;
      ticks.values.push_back(value);
      ticks.labels.push_back(fmt::format("{:.{}f}", value, decimals));
    }
    return ticks;
  }
}

}  // namespace feedscope::ui
