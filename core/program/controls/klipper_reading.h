#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/program/controls/klipper_settings.h"
#include "core/program/program.h"

namespace feedscope {

/// Reads a program as Klipper does (models/klipper/README.md, "Reading"): every line must begin with its
/// command; unknown commands and those with errors have no effect and are notes of code "refused". Rapids run
/// at the feed in force. Moves of the extruder alone become dwells of the time that they take within
/// `limits`, which M204 and SET_VELOCITY_LIMIT change.
ReadProgram read_as_klipper(std::shared_ptr<const SourceText> source, const KlipperSettings& limits,
                            const Progress* progress = nullptr);

}  // namespace feedscope
