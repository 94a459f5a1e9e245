#pragma once

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/path_modes.h"

namespace feedscope::sinumerik {

/// G4: waits for F seconds or S revolutions of the spindle.
class Dwells : private Part {
 public:
  /// Both outlive it.
  Dwells(Context& context, PathModes& path_modes) : Part(context), path_modes_(path_modes) {}

  void run();

 private:
  PathModes& path_modes_;
};

}  // namespace feedscope::sinumerik
