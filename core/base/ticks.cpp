#include "core/base/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace feedscope {

namespace {

constexpr double max_values = 1000;

/// Smallest step that is round on a clock and at least `step` [s].
double round_up_clock(double step) {
  constexpr double hour = 3600;
  if (step <= 1) {
    return round_up_125(step);
  }
  for (const double round :
       {2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0, 1200.0, 1800.0, hour}) {
    if (step <= round * (1 + 1e-9)) {
      return round;
    }
  }
  return hour * round_up_125(step / hour);
}

/// Ticks with the steps that `round_up` returns, the smallest at least as large as its argument; neighbouring
/// steps differ by a factor of at most 2.5.
template <class RoundUp>
Ticks ticks_by(RoundUp round_up, double minimum, double maximum, double most, double low, double high) {
  Ticks ticks;
  const double range = maximum - minimum;
  if (!(range > 0) || !std::isfinite(range) || !(most >= 1)) {
    return ticks;
  }
  const double slack = 1e-9 * range;
  const double from = std::max(minimum, low) - slack;
  const double to = std::min(maximum, high) + slack;
  for (double step = round_up(range / most);; step = round_up(step * 1.2)) {
    const double count = std::floor((maximum + slack) / step) - std::ceil((minimum - slack) / step) + 1;
    if (count > most || std::floor(to / step) - std::ceil(from / step) >= max_values) {
      continue;
    }
    constexpr double always_two = 5;
    if (count < 2 && most >= 2 && most < always_two) {
      return ticks_by(round_up, minimum, maximum, always_two, low, high);
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
  return round_ticks_between(minimum, maximum, std::max(most, 2), minimum, maximum);
}

Ticks clock_ticks(double minimum, double maximum, int most) {
  constexpr double minute = 60;
  return maximum < minute ? round_ticks(minimum, maximum, most)
                          : ticks_by(round_up_clock, minimum, maximum, std::max(most, 2), minimum, maximum);
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
  return ticks_by(round_up_125, minimum, maximum, most, low, high);
}

}  // namespace feedscope
