#pragma once

#include <QString>

#include "core/trajectory/trajectory.h"

namespace feedscope::ui {

/// Differences between two instants of a run, the second less the first.
struct Measurement {
  double time = 0;         ///< [s]
  double path_length = 0;  ///< executed [mm]
  double mean_feed = 0;    ///< path length over time [mm/s]; 0 for equal times
  double feed = 0;         ///< difference of the achieved feeds [mm/s]
};

Measurement measure(const State& first, const State& second);

/// "A → B:   Δt 0.25 s   ·   ...".
QString text_of(const Measurement& between);

}  // namespace feedscope::ui
