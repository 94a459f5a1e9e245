#include "core/base/clock_text.h"

#include <fmt/format.h>

#include <cmath>

namespace feedscope {

std::string clock_text(double seconds) {
  const long long whole = std::llround(seconds);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace feedscope
