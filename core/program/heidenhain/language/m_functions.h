#pragma once

#include <cstdint>

#include "core/program/heidenhain/cycles/cycles.h"
#include "core/program/heidenhain/geometry/path_modes.h"
#include "core/program/heidenhain/geometry/targets.h"
#include "core/program/heidenhain/language/tools.h"

namespace feedscope::heidenhain {

/// M words. Some act before the motion of their block and some after it.
class MFunctions : private Part {
 public:
  /// Parts on which the functions act; all outlive it.
  struct Parts {
    Feeds& feeds;
    Tools& tools;
    const Targets& targets;
    PathModes& path_modes;
    Cycles& cycles;
    Calls& calls;
  };
  MFunctions(Context& context, const Parts& parts) : Part(context), parts_(parts) {}

  /// Reads an M and the words that belong to it. Throws ReadFault.
  void read(Scanner& scanner, std::uint32_t column, MotionWords& words) const;
  /// Runs those that act before the motion.
  void start(const MotionWords& words);
  /// Runs those that act after it; `moved`: the block has a motion.
  void finish(const MotionWords& words, bool moved);

 private:
  void retract(const MotionWords& words);

  Parts parts_;
};

}  // namespace feedscope::heidenhain
