#pragma once

// Room `load`: what the tool bears. A load file says how tools are engaged in which material; LoadModel finds
// the operation of a motion, cutting_force.h gives chip thickness, force, torque and power at a feed.

#include <cstdint>
#include <vector>

#include "core/load/cutting_force.h"
#include "core/load/load_file.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// An operation with its material and forces.
struct LoadedOperation {
  Engagement operation;
  Material material;
  CuttingForce force;
};

/// Assigns operations to the motions of a program.
class LoadModel {
 public:
  /// `toolpath`: of `program`. Throws InputError for an operation with a tool that the program never loads,
  /// lines that it does not have or an unknown material, and for operations that overlap.
  LoadModel(LoadSetup setup, const Program& program, const Toolpath& toolpath);

  const LoadSetup& setup() const { return setup_; }
  const std::vector<LoadedOperation>& operations() const { return operations_; }
  /// Index in operations(), -1 if none applies: one with lines precedes one without, one of the tool precedes
  /// one of all tools. `spindle`: index into Toolpath::spindles.
  int operation_of(std::uint16_t spindle, std::uint32_t line) const;
  /// Spindle speed of a motion of this operation [1/s]: the program's, else the operation's; 0 if the spindle
  /// is at rest or its speed is unknown.
  double speed_of(int operation, std::uint16_t spindle) const;

 private:
  struct Range {
    ProgramLines lines;
    int operation = -1;
  };
  /// Operations of a tool.
  struct ByTool {
    std::vector<Range> ranges;  ///< sorted by line, disjoint
    int elsewhere = -1;
  };

  LoadSetup setup_;
  std::vector<LoadedOperation> operations_;
  std::vector<ByTool> by_tool_;         ///< index: SpindleState::tool + 1
  std::vector<SpindleState> spindles_;  ///< of the toolpath
};

}  // namespace feedscope
