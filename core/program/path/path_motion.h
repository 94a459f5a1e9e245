#pragma once

#include <array>

#include "core/program/program.h"
#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// A motion to be written, in shown coordinates.
struct PathMotion {
  MotionBlock block;  ///< its `arc` is not used
  ArcWords arc;       ///< arcs only
  DiagnosticLog::Place place;
  std::array<bool, 3> axes{};  ///< programmed by the block
};

}  // namespace feedscope
