#pragma once

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/path_modes.h"

namespace feedscope::sinumerik {

/// Moves to positions that depend on the machine: coordinates of the machine (G53, G153, SUPA), the reference
/// point (G74), fixed points (G75, FP).
class MachinePositions : private Part {
 public:
  /// Both outlive it.
  MachinePositions(Context& context, PathModes& path_modes) : Part(context), path_modes_(path_modes) {}

  /// Moves by the functions of the block; without X, Y and Z all three axes move.
  void move();

 private:
  AxisPlace place_of(std::size_t axis) const;

  PathModes& path_modes_;
};

}  // namespace feedscope::sinumerik
