#pragma once

#include <memory>

#include "core/trajectory/trajectory.h"

namespace feedscope {

/// The motion of `run`, which is on `merged`->path, with every element and piece on its block of
/// `programmed`, from which merge_collinear() made `merged`. A line that represents several blocks becomes
/// one element for each, up to their common point in the program. A block that lies within a corner's part of
/// the line has no element.
Trajectory on_program_blocks(const Trajectory& run, std::shared_ptr<const Toolpath> programmed,
                             const std::shared_ptr<const CompactedPath>& merged);

}  // namespace feedscope
