#pragma once

#include <array>

namespace feedscope {

/// Where the axes A, B and C are at one instant; of one that the machine does not have not a number.
struct RotarySample {
  std::array<double, 3> angle{};     ///< [rad]
  std::array<double, 3> velocity{};  ///< [rad/s]
};

}  // namespace feedscope
