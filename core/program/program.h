#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/base/progress.h"
#include "core/program/source_text.h"

namespace feedscope {

enum class Motion : std::uint8_t { rapid, line, arc, dwell };

/// How an arc block turns; centre and axis are resolved from I J K, R, plane and modes.
struct ArcWords {
  Vec3 center;       ///< in the plane of the arc; along the axis as the start point [mm]
  Vec3 axis;         ///< unit vector; the motion is counter-clockwise seen against it
  double turns = 0;  ///< whole turns on top of the partial one; 1 for a full circle, whose ends coincide
};

/// A block that moves or waits, modal state resolved: absolute, metric, modal words filled in.
struct MotionBlock {
  Vec3 target;             ///< position at the block's end [mm]
  double feed = 0;         ///< programmed feed [mm/s]; 0 for rapids and dwells
  double dwell = 0;        ///< [s], dwells only
  std::uint32_t line = 0;  ///< 1-based line in the source
  std::int32_t arc = -1;   ///< index into Program::arcs, arcs only
  Motion motion = Motion::line;
};

/// What a program says, free of its dialect.
struct Program {
  std::shared_ptr<const SourceText> source;
  std::uint32_t block_count = 0;  ///< lines that hold at least one word
  std::vector<MotionBlock> motions;
  std::vector<ArcWords> arcs;
  Bounds bounds;  ///< of all programmed positions, see read_program [mm]
  std::vector<Diagnostic> diagnostics;
};

/// Reads the ISO core: G0-G4, G17-G21, G90-G91.1, G94, F S T M N, comments.
///
/// The tool starts at X0 Y0 Z0. `bounds` leaves that assumed place out: a coordinate counts from the first
/// block that programs its axis, or from the first feed motion. Arcs count with their full extent.
/// A wrong line is a diagnostic and reading goes on; `progress` may stop the reading (throws Cancelled).
Program read_program(std::shared_ptr<const SourceText> source, Progress* progress = nullptr);

}  // namespace feedscope
