#pragma once

#include <limits>
#include <vector>

#include "core/blend/path_rules.h"
#include "core/limits/segment_limits.h"
#include "core/trajectory/pulse_train.h"

namespace feedscope {

/// Pulses of a stretch while they are chosen. Blocks count from the start of the stretch.
struct WardPulses {
  PulseTrain train;
  std::vector<SpeedBound> limits;     ///< of the feed, by block
  std::vector<double> corner_speeds;  ///< at the start of every block, for the next laying [mm/s]

  bool is_arc(std::size_t block) const { return train.segment(block).kind == SegmentKind::arc; }
  /// Contour tolerance at the start of a block, > 0 [mm].
  double corner_tolerance(const PathRules& rules, std::size_t block) const {
    return rules.corner_tolerance(train.first + block - 1);
  }
  /// Tolerance inside an arc; infinite for one of tolerance 0, which no filtered motion keeps [mm].
  double arc_tolerance(const PathRules& rules, std::size_t block) const {
    const double tolerance = rules.tolerance(train.first + block);
    return tolerance > 0 ? tolerance : std::numeric_limits<double>::infinity();
  }
};

/// True if a distance is above a tolerance [mm] by more than rounding.
inline bool exceeds(double distance, double tolerance) {
  constexpr double rounding = 1e-6;
  return distance > tolerance * (1 + rounding);
}

}  // namespace feedscope
