#include "core/base/clock_text.h"

#include <fmt/format.h>

#include <cmath>

namespace feedscope {

std::string clock_text(double seconds) {
  const long long whole = std::llround(seconds);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string seconds_text(double seconds) {
  constexpr double half_of_last_place = 5e-4;
  return fmt::format("{:.3f} s", std::abs(seconds) < half_of_last_place ? 0.0 : seconds);
}

}  // namespace feedscope
