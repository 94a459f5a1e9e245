#pragma once

#include <array>
#include <cstddef>

namespace feedscope {

/// Set position of one axis over a short time: a polynomial, as its derivatives at the start.
struct SetCourse {
  static constexpr std::size_t order = 9;  ///< highest nonzero derivative
  static constexpr std::size_t met = 4;    ///< derivatives of both ends matched by a polynomial of that order
  using Derivatives = std::array<double, order + 1>;
  /// 1/k
  static constexpr Derivatives inverse{0,       1,       1.0 / 2, 1.0 / 3, 1.0 / 4,
                                       1.0 / 5, 1.0 / 6, 1.0 / 7, 1.0 / 8, 1.0 / 9};

  Derivatives derivative{};    ///< [0] position [mm], [k] its k-th derivative [mm/s^k]
  double duration = 0;         ///< [s]
  std::size_t degree = order;  ///< higher derivatives are 0; at least 1

  /// Distance from the position at the start, `h` [s] after it [mm].
  double travel(double h) const;
  double velocity(double h) const;  ///< [mm/s]
};

/// Changes the derivatives from the fifth on so that the polynomial and its first four derivatives are `end`
/// after `h` [s], those of the start being given.
void meet_end(SetCourse::Derivatives& derivative, const std::array<double, SetCourse::met + 1>& end,
              double h);

}  // namespace feedscope
