#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/analysis/envelope/band.h"
#include "core/base/progress.h"

namespace feedscope {

/// What a run usually does in stretches of time, where the extremes alone say little: in charts of hours.
struct UsualMotion {
  /// Of each stretch and quantity the values that lie between 5 and 95 % of its time; empty where fewer than
  /// 20 instants count.
  std::vector<MotionBand> ranges;
  std::vector<float> feeds;  ///< achieved, of all instants, ascending [mm/s]: each stands for as much time
};

inline constexpr double usual_from = 0.05;  ///< share of the time below the usual range
inline constexpr double usual_to = 0.95;
inline constexpr int usual_instants = 192;  ///< of each stretch

/// Looks at `instants` of each pair of neighbours in `times` [s], ascending: one somewhere in each of as many
/// equal parts, so that nothing that repeats itself is met at one phase alone. A percentile is then that of a
/// share of time at most 1/`instants` away, on average of many stretches; its cost does not depend on the
/// length of the program. `rapids`: whether rapids count.
/// Throws Cancelled if `progress` is cancelled.
UsualMotion usual_motion(const Trajectory& trajectory, std::span<const double> times, bool rapids,
                         int instants = usual_instants, Progress* progress = nullptr);

}  // namespace feedscope
