#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace feedscope {

/// Makes room for `more` values; where that takes a copy, for what the whole will need, of which `done` in
/// (0, 1] is there then.
template <class T>
void make_room(std::vector<T>& values, std::size_t more, double done) {
  constexpr double slack = 1.02;
  const std::size_t needed = values.size() + more;
  if (needed > values.capacity()) {
    values.reserve(static_cast<std::size_t>(std::ceil(slack * static_cast<double>(needed) / done)));
  }
}

}  // namespace feedscope
