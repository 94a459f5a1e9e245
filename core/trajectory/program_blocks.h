#pragma once

#include <memory>

#include "core/trajectory/trajectory.h"

namespace feedscope {

/// `run` of `merged`->path, the same motion with every element and piece on its block of `programmed`, of
/// which `merged` was made by merge_collinear(): a line that stands for several blocks becomes an element for
/// each, up to where the program has their common point. What a corner takes of the line leaves no element of
/// a block that lies in it.
Trajectory on_program_blocks(const Trajectory& run, std::shared_ptr<const Toolpath> programmed,
                             const std::shared_ptr<const CompactedPath>& merged);

}  // namespace feedscope
