#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/analysis/rotary/rotary_course.h"
#include "core/analysis/run/axis_peaks.h"
#include "core/base/progress.h"

namespace feedscope {

/// Largest deviation of the tool from its programmed direction, where the courses of rotary axes are rounded
/// between blocks.
struct OrientationError {
  double angle = 0;        ///< [rad]
  std::uint32_t line = 0;  ///< of the block that ends or is there; 0 without one
};

/// Figures of a run in which rotary axes turn.
struct RotaryFigures {
  /// Of A, B and C; NaN for axes that the machine lacks. Acceleration and jerk exclude the steps at the ends
  /// of curves in corners (RotaryCourse).
  std::array<AxisPeaks, 3> rotary{};
  /// Of X, Y and Z of the machine along blocks in which rotary axes turn under tool centre point control;
  /// none without such a block, or if tool length or part zero are unknown.
  std::optional<std::array<AxisPeaks, 3>> linear;
  OrientationError orientation;
};

/// `limits_jerk`: as in RunSources; without it jerks are NaN. Throws Cancelled when stopped.
RotaryFigures rotary_figures(const std::shared_ptr<const RotaryCourse>& course, bool limits_jerk,
                             const Progress* progress = nullptr);

}  // namespace feedscope
