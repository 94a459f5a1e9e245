#pragma once

#include <cstddef>
#include <vector>

#include "core/analysis/contour/chord_error.h"
#include "core/toolpath/machine_path.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Lines whose motions have one path control.
struct PathControlRange {
  std::uint32_t first_line = 0;
  std::uint32_t last_line = 0;
  PathControl control;
};

/// Facts about a program, independent of machine and model.
struct ProgramFacts {
  std::size_t lines = 0;
  std::size_t blocks = 0;                      ///< lines with at least one word
  std::size_t segments = 0;                    ///< lines, arcs and dwells
  std::size_t arcs = 0;                        ///< arcs and helices among the segments
  std::size_t dwells = 0;                      ///< among the segments
  NotCounted not_counted;                      ///< events without a time in the program
  Bounds bounds;                               ///< as Program::bounds [mm]
  Bounds cutting_bounds;                       ///< of the feed motions [mm]
  Bounds rapid_bounds;                         ///< of the rapids [mm]
  double path_length = 0;                      ///< rapids included [mm]
  double rapid_length = 0;                     ///< [mm]
  double dwell_time = 0;                       ///< [s]
  double min_feed = 0;                         ///< over motions with a programmed feed; 0 without any [mm/s]
  double largest_feed = 0;                     ///< [mm/s]
  std::optional<ChordError> chord_error;       ///< of short lines, if there are enough of them
  std::vector<PathControlRange> path_control;  ///< in programmed order, dwells omitted
};

ProgramFacts facts_of(const Program& program, const Toolpath& toolpath);

}  // namespace feedscope
