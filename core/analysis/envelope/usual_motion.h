#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/analysis/envelope/band.h"
#include "core/base/progress.h"

namespace feedscope {

/// Usual motion of a run in stretches of time, for charts of hours, where extremes alone tell little.
struct UsualMotion {
  /// Range of values within 5 and 95 % of the time, for each stretch and quantity; empty if fewer than 20
  /// instants count.
  std::vector<MotionBand> ranges;
  std::vector<float> feeds;  ///< achieved, of all instants, ascending [mm/s]; all with equal weight in time
};

inline constexpr double usual_from = 0.05;  ///< share of the time below the usual range
inline constexpr double usual_to = 0.95;
inline constexpr int usual_instants = 192;  ///< per stretch

/// Samples `instants` between each pair of neighbours in `times` [s], ascending: one in each of as many equal
/// parts, at changing phases, so that periodic motion is not always sampled at the same phase. On average
/// over many stretches a percentile is off by at most 1/`instants` of the time; the cost does not depend on
/// the length of the program. `rapids`: include rapids. Throws Cancelled if `progress` is cancelled.
UsualMotion usual_motion(const Trajectory& trajectory, std::span<const double> times, bool rapids,
                         int instants = usual_instants, Progress* progress = nullptr);

}  // namespace feedscope
