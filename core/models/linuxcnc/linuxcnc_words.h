#pragma once

#include <cstdint>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Commands of a program that wait until all motion has ended and are no motion: spindle, coolant, offsets,
/// stops. They are read in the lines between two motions, where the toolpath knows its text.
class LinuxCncWaits {
 public:
  explicit LinuxCncWaits(const Toolpath& toolpath) : toolpath_(toolpath) {}

  struct Found {
    int count = 0;
    bool spindle_starts = false;
  };
  /// Of the lines behind segment `i` - 1 up to that of segment `i`; to be asked in rising order. Where O
  /// words stand between them: up to the first of them, and behind the last one before segment `i`.
  Found before(std::size_t i);

 private:
  const Toolpath& toolpath_;
  std::uint32_t line_ = 0;  ///< up to which lines are read
};

}  // namespace feedscope
