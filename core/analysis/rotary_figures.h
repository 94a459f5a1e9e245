#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/analysis/axis_peaks.h"
#include "core/analysis/rotary_course.h"
#include "core/base/progress.h"

namespace feedscope {

/// How far the tool leans from its programmed direction at most, where the courses of rotary axes are rounded
/// between blocks.
struct OrientationError {
  double angle = 0;        ///< [rad]
  std::uint32_t line = 0;  ///< of the block that ends or is there; 0: nowhere
};

/// Figures of a run in which rotary axes turn.
struct RotaryFigures {
  /// Of A, B and C; not numbers of one that the machine does not have. What the curves in corners add where
  /// they begin and end (RotaryCourse) is not in acceleration and jerk.
  std::array<AxisPeaks, 3> rotary{};
  /// Of X, Y and Z of the machine along blocks in which rotary axes turn under tool centre point control;
  /// none without such a block, or where tool length or part zero are unknown.
  std::optional<std::array<AxisPeaks, 3>> linear;
  OrientationError orientation;
};

/// `limits_jerk`: as RunSources; else jerks are not numbers. Throws Cancelled when stopped.
RotaryFigures rotary_figures(const std::shared_ptr<const RotaryCourse>& course, bool limits_jerk,
                             const Progress* progress = nullptr);

}  // namespace feedscope
