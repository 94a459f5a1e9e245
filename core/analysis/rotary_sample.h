#pragma once

#include <array>
#include <limits>

namespace feedscope {

/// Where an axis is at one instant, and how it moves.
struct AxisState {
  double position = 0;      ///< [rad], [mm]
  double velocity = 0;      ///< [rad/s], [mm/s]
  double acceleration = 0;  ///< [rad/s2], [mm/s2]
  double jerk = 0;          ///< [rad/s3], [mm/s3]

  static AxisState unknown() {
    constexpr double number = std::numeric_limits<double>::quiet_NaN();
    return {number, number, number, number};
  }
};

/// The axes of a machine with rotary ones at one instant.
struct RotarySample {
  std::array<AxisState, 3> rotary{};  ///< A, B and C; of one that the machine does not have not a number
  /// X, Y and Z of the machine, which hold the tip on its path while rotary axes turn under tool centre point
  /// control; elsewhere, and where it is not known how they follow, not a number.
  std::array<AxisState, 3> linear{AxisState::unknown(), AxisState::unknown(), AxisState::unknown()};

  /// Of A, B and C.
  std::array<double, 3> angles() const {
    return {rotary[0].position, rotary[1].position, rotary[2].position};
  }
};

}  // namespace feedscope
