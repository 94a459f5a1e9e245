#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/limits/formula.h"

namespace feedscope {

/// Elements that are searched to both sides for the one that limits a ramp.
inline constexpr std::uint32_t farthest_of_ramp = 500;

/// Whether a formula that gives the one explains the other.
inline bool about_equal(double a, double b) {
  constexpr double rounding = 1e-5;
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

/// Calls `look` for `middle`, its neighbours, theirs and so on below `size`, until it says so.
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

/// How far `formula` is from giving `reached`, as a share.
inline double mismatch(const Formula& formula, double reached) {
  return formula.empty() || !(reached > 0) ? std::numeric_limits<double>::infinity()
                                           : std::abs(formula.value() / reached - 1);
}

}  // namespace feedscope
