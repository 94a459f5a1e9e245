#pragma once

#include <limits>
#include <vector>

#include "core/blend/path_rules.h"
#include "core/limits/segment_limits.h"
#include "core/trajectory/pulse_train.h"

namespace feedscope {

/// The pulses of a stretch while they are chosen. Blocks count from the start of the stretch.
struct WardPulses {
  PulseTrain train;
  std::vector<SpeedBound> limits;     ///< of the feed, a block
  std::vector<double> corner_speeds;  ///< at the start of every block, to be laid next [mm/s]

  bool is_arc(std::size_t block) const { return train.segment(block).kind == SegmentKind::arc; }
  /// Contour tolerance at the start of a block, > 0 [mm].
  double corner_tolerance(const PathRules& rules, std::size_t block) const {
    return rules.corner_tolerance(train.first + block - 1);
  }
  /// Inside an arc; infinite for one of tolerance 0, which no filtered motion keeps [mm].
  double arc_tolerance(const PathRules& rules, std::size_t block) const {
    const double tolerance = rules.tolerance(train.first + block);
    return tolerance > 0 ? tolerance : std::numeric_limits<double>::infinity();
  }
};

/// Whether a distance is above a tolerance [mm], but for rounding.
inline bool exceeds(double distance, double tolerance) {
  constexpr double rounding = 1e-6;
  return distance > tolerance * (1 + rounding);
}

}  // namespace feedscope
