#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace feedscope {

/// Reserves room for `more` values; if that requires a copy, for the whole, of which the share `done` in (0,
/// 1] is then complete.
template <class T>
void make_room(std::vector<T>& values, std::size_t more, double done) {
  constexpr double slack = 1.02;
  const std::size_t needed = values.size() + more;
  if (needed > values.capacity()) {
    values.reserve(static_cast<std::size_t>(std::ceil(slack * static_cast<double>(needed) / done)));
  }
}

}  // namespace feedscope
