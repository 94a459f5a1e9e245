#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/program/program.h"

namespace feedscope {

/// Reads a program as grbl 1.1 does (models/grbl/README.md, "Reading"). A rejected line has no effect at all,
/// not even its feed, and is a note of code "refused". Motions are in machine coordinates, work offsets zero
/// until the program sets them. Where grbl waits until all motion has ended there is a dwell, with a time
/// only for G4. `arc_tolerance`: $12, which determines the feed of G93 on arcs [mm].
ReadProgram read_as_grbl(std::shared_ptr<const SourceText> source, float arc_tolerance,
                         const Progress* progress = nullptr);

}  // namespace feedscope
