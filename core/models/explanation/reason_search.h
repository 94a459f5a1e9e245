#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/limits/formula.h"

namespace feedscope {

/// Number of elements searched on both sides for the one that limits a ramp.
inline constexpr std::uint32_t farthest_of_ramp = 500;

/// Number of elements searched on both sides for the one that limits a speed.
inline constexpr std::uint32_t farthest_of_speed = 3;

/// Whether a formula that gives one value explains the other.
inline bool about_equal(double a, double b) {
  constexpr double rounding = 1e-5;
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

/// Calls `look` for `middle`, its neighbours, theirs and so on below `size`, until it returns true.
template <typename Look>
void look_around(std::uint32_t middle, std::uint32_t farthest, std::size_t size, const Look& look) {
  if (look(middle)) {
    return;
  }
  for (std::uint32_t d = 1; d <= farthest; ++d) {
    const bool found = (middle >= d && look(middle - d)) || (middle + d < size && look(middle + d));
    if (found || (middle < d && middle + d >= size)) {
      return;
    }
  }
}

/// Relative difference between `formula` and `reached`.
inline double mismatch(const Formula& formula, double reached) {
  return formula.empty() || !(reached > 0) ? std::numeric_limits<double>::infinity()
                                           : std::abs(formula.value() / reached - 1);
}

}  // namespace feedscope
