#include "core/base/short_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/clock_text.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double nanometre = 1e-6;  // [mm]; less is shown as zero

/// Three significant figures without a power of ten: "2.00", "48.5", "1250".
std::string three_figures(double value) {
  if (!(std::abs(value) > 0) || !std::isfinite(value)) {
    return fmt::format("{}", value);
  }
  const auto decimals_of = [](double size) { return 2 - static_cast<int>(std::floor(std::log10(size))); };
  const int decimals = decimals_of(std::abs(value));
  const double step = std::pow(10, -decimals);
  const double rounded = std::round(std::abs(value) / step) * step;  // 9.996 has one decimal less than 9.99
  return fmt::format("{:.{}f}", value, std::max(std::min(decimals, decimals_of(rounded)), 0));
}

std::string without_zeros(std::string text) {
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
  }
  return text;
}

}  // namespace

std::string short_time(double seconds) {
  constexpr double minute = 60;
  constexpr double hour = 3600;
  const double tenths = std::round(10 * seconds) / 10;
  constexpr double in_ms = 0.1;  // [s]
  if (seconds < in_ms) {
    constexpr double milli = 1e3;
    return seconds > 0 ? three_figures(milli * seconds) + " ms" : "0 s";
  }
  if (tenths < minute) {
    return three_figures(seconds) + " s";
  }
  if (tenths >= hour) {
    return clock_text(seconds);
  }
  const double minutes = std::floor(tenths / minute);
  return fmt::format("{:.0f}:{:04.1f}", minutes, tenths - minute * minutes);
}

std::string short_length(double mm) {
  constexpr double in_um = 0.1;  // [mm]
  const double shown = mm < nanometre ? 0 : mm;
  return shown < in_um ? without_zeros(three_figures(units::to_um(shown))) + " um"
                       : without_zeros(three_figures(shown)) + " mm";
}

std::string short_percent(double share) {
  const double percent = 100 * share;
  const double size = std::abs(percent);
  return size >= 2   ? fmt::format("{:.0f} %", percent)
         : size >= 1 ? fmt::format("{:.1f} %", percent)
                     : fmt::format("{:.1g} %", percent);
}

}  // namespace feedscope
