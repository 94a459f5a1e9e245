#include "core/base/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace feedscope {

namespace {

constexpr double max_values = 1000;

}  // namespace

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

double step_of_two(double low, double high) {
  for (double power = std::pow(10.0, std::ceil(std::log10(high - low)));; power /= 10) {
    for (const double factor : {8.0, 6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.5, 1.2, 1.0}) {
      const double step = factor * power;
      if (std::floor(high / step) - std::ceil(low / step) >= 1) {
        return step;
      }
    }
  }
}

int step_decimals(double step) {
  constexpr int most = 12;
  int decimals = 0;
  for (double left = step; decimals < most && std::abs(left - std::round(left)) > 1e-9 * left; left *= 10) {
    ++decimals;
  }
  return decimals;
}

std::string tick_label(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 12);
  return fmt::format("{:.{}f}", value, decimals);
}

Ticks round_ticks(double minimum, double maximum, int most) {
  return round_ticks_between(minimum, maximum, most, minimum, maximum);
}

std::vector<double> multiples(double step, double low, double high) {
  std::vector<double> values;
  if (!(step > 0) || !std::isfinite(high - low)) {
    return values;
  }
  while (std::floor(high / step) - std::ceil(low / step) >= max_values) {
    step = round_up_125(step * 1.5);
  }
  const double last = std::floor(high / step);
  for (double k = std::ceil(low / step); k <= last; ++k) {
    values.push_back(k == 0 ? 0.0 : k * step);
  }
  return values;
}

Ticks round_ticks_between(double minimum, double maximum, double most, double low, double high) {
  Ticks ticks;
  const double range = maximum - minimum;
  if (!(range > 0) || !std::isfinite(range) || !(most >= 1)) {
    return ticks;
  }
  const double slack = 1e-9 * range;
  const double from = std::max(minimum, low) - slack;
  const double to = std::min(maximum, high) + slack;
  for (double step = round_up_125(range / most);; step = round_up_125(step * 1.5)) {
    const double count = std::floor((maximum + slack) / step) - std::ceil((minimum - slack) / step) + 1;
    if (count > most || std::floor(to / step) - std::ceil(from / step) >= max_values) {
      continue;
    }
    constexpr double always_two = 5;  // neighbouring steps differ by a factor of at most 2.5
    if (count < 2 && most >= 2 && most < always_two) {
      return round_ticks_between(minimum, maximum, always_two, low, high);
    }
    ticks.step = step;
    ticks.count = count;
    ticks.values = multiples(step, from, to);
    for (const double value : ticks.values) {
      ticks.labels.push_back(tick_label(value, step));
    }
    return ticks;
  }
}

}  // namespace feedscope
