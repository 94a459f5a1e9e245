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
  Vec3 center;       ///< at equal distances from both ends, along the axis as the start point [mm]
  Vec3 axis;         ///< unit vector; the motion is counter-clockwise seen against it
  double turns = 0;  ///< whole turns on top of the partial one; 1 for a full circle, whose ends coincide
};

/// A block that moves or waits, modal state resolved: absolute, metric, modal words filled in.
struct MotionBlock {
  Vec3 target;             ///< position at the block's end [mm]
  double feed = 0;         ///< programmed feed [mm/s]; 0: as fast as the axes allow (rapids, missing feed)
  double dwell = 0;        ///< [s], dwells only
  std::uint32_t line = 0;  ///< 1-based line in the source
  std::int32_t arc = -1;   ///< index into Program::arcs, arcs only
  Motion motion = Motion::line;
};

/// What a program says, free of its dialect.
struct Program {
  std::shared_ptr<const SourceText> source;
  std::uint32_t block_count = 0;  ///< lines with words, readable or not, up to the program's end
  std::vector<MotionBlock> motions;
  std::vector<ArcWords> arcs;
  /// Of the programmed points; Toolpath::bounds adds what arcs reach beyond them [mm]. The tool starts at
  /// X0 Y0 Z0, an assumed place that is left out: a coordinate counts from the first block that programs
  /// its axis, or from the start of the first feed motion.
  Bounds bounds;
  std::vector<Diagnostic> diagnostics;
};

struct ReadOptions {
  bool skip_deleted_blocks =
      false;  ///< as with the control's block delete switch on: "/" blocks are left out
};

/// Reads the ISO core: G0-G4, G17-G21, G90-G91.1, G94, F S T M N, comments; see README.md beside this file.
///
/// A wrong line is a diagnostic and reading goes on; `progress` may stop the reading (throws Cancelled).
/// A block whose position words cannot be read does not move; an arc that cannot be one becomes a line to
/// its end, so that the position goes on.
Program read_program(std::shared_ptr<const SourceText> source, Progress* progress = nullptr,
                     const ReadOptions& options = {});

}  // namespace feedscope
