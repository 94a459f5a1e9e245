#pragma once

#include <cstdint>
#include <vector>

#include "core/load/cutting_force.h"
#include "core/load/load_file.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// An operation with what its material makes of it.
struct LoadedOperation {
  Engagement operation;
  Material material;
  CuttingForce force;
};

/// Which operation applies to which motion of a program.
class LoadModel {
 public:
  /// `toolpath`: of `program`. Throws InputError for an operation of a tool that the program never changes
  /// to, of lines that it does not have, of an unknown material, and for operations that overlap.
  LoadModel(LoadSetup setup, const Program& program, const Toolpath& toolpath);

  const LoadSetup& setup() const { return setup_; }
  const std::vector<LoadedOperation>& operations() const { return operations_; }
  /// Position in operations(), -1 where none applies: one with lines before one without, one of the tool
  /// before one of all tools. `spindle`: index into Toolpath::spindles.
  int operation_of(std::uint16_t spindle, std::uint32_t line) const;
  /// Spindle speed of a motion of this operation [1/s]: the program's, else the operation's; 0 where the
  /// spindle stands or its speed is not known.
  double speed_of(int operation, std::uint16_t spindle) const;

 private:
  struct Range {
    ProgramLines lines;
    int operation = -1;
  };
  /// What applies to a tool.
  struct ByTool {
    std::vector<Range> ranges;  ///< by line, apart from each other
    int elsewhere = -1;
  };

  LoadSetup setup_;
  std::vector<LoadedOperation> operations_;
  std::vector<ByTool> by_tool_;         ///< by SpindleState::tool + 1
  std::vector<SpindleState> spindles_;  ///< of the toolpath
};

}  // namespace feedscope
