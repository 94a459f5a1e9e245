#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/program/program.h"

namespace feedscope {

/// Reads a program as a grbl 1.1 does (README.md, "Reading"): a line that it rejects has no effect at all,
/// not even its feed, and is a note of code "refused". Motions are in machine coordinates, work offsets being
/// zero until the program sets them. Where grbl waits until all motion has ended, a dwell stands, of no time
/// of its own but for G4. `arc_tolerance`: $12, which tells what the feed of G93 becomes on arcs [mm].
Program read_as_grbl(std::shared_ptr<const SourceText> source, float arc_tolerance,
                     const Progress* progress = nullptr);

}  // namespace feedscope
