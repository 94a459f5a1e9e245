#pragma once

#include <array>
#include <limits>

namespace feedscope {

/// Position and motion of an axis at one instant.
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

/// Axes of a machine with rotary axes at one instant.
struct RotarySample {
  std::array<AxisState, 3> rotary{};  ///< A, B and C; NaN for axes that the machine lacks
  /// X, Y and Z of the machine, which keep the tip on its path while rotary axes turn under tool centre point
  /// control; otherwise, and if unknown, NaN.
  std::array<AxisState, 3> linear{AxisState::unknown(), AxisState::unknown(), AxisState::unknown()};

  /// Of A, B and C.
  std::array<double, 3> angles() const {
    return {rotary[0].position, rotary[1].position, rotary[2].position};
  }
};

}  // namespace feedscope
