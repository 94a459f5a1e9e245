#pragma once

#include <optional>

#include "core/program/cycles/drill_plan.h"

namespace feedscope {

/// A thread that is tapped in one go or in strokes, as by Fanuc G84 with Q, Sinumerik CYCLE84 and Heidenhain
/// 206, 207 and 209. Levels are along the tool's axis [mm], whichever direction leads into the hole.
struct Tapping {
  double safe = 0;     ///< level from which the tap feeds and to which it returns
  double surface = 0;  ///< level from which strokes are measured
  double bottom = 0;   ///< level of the thread's end
  double stroke = 0;   ///< depth of one stroke [mm]; 0: in one go
  double lift = 0;     ///< after each stroke, to break chips [mm]; 0: out of the hole, to clear them
  double dwell = 0;    ///< at the bottom [s]
  std::optional<DrillFeed> down = std::nullopt;  ///< none: as the program feeds
  std::optional<DrillFeed> back = std::nullopt;  ///< out of the hole; none: as the program feeds
};

/// Limit of the strokes of a thread; above it, it is tapped in one go.
constexpr double max_tapping_strokes = 10000;

/// Adds the steps from `safe` into the hole and back to `safe`.
void tap(const Tapping& tapping, DrillPlan& plan);

}  // namespace feedscope
