#pragma once

#include <cstdint>
#include <limits>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Commands of a program that wait until all motion has ended but are no motion: spindle, coolant, offsets,
/// stops. They are read from the lines between two motions, if the toolpath has its text.
class LinuxCncWaits {
 public:
  explicit LinuxCncWaits(const Toolpath& toolpath) : toolpath_(toolpath) {}

  struct Found {
    int count = 0;
    bool spindle_starts = false;
  };
  /// Commands in the lines after segment `i` - 1 up to that of segment `i`; call it in rising order. If these
  /// lines contain words that lead elsewhere, such as O words, WHILE or M98: up to the first of them, and
  /// after the last one before segment `i`. If the program goes back to a line without a beginning of a loop
  /// or subprogram before it: of that line alone. Linear in the lines that run.
  Found before(std::size_t i);

 private:
  void take(std::uint32_t first, std::uint32_t last, Found& all) const;
  void go_back_to(std::uint32_t line, Found& all);

  const Toolpath& toolpath_;
  std::uint32_t line_ = 0;        ///< up to which lines have been read
  std::uint32_t without_to_ = 0;  ///< lines 1 to this one contain no jumps
  std::uint32_t without_from_ = std::numeric_limits<std::uint32_t>::max();  ///< nor do those from this one on
};

/// True if a line contains M7, M8 or M9.
bool switches_coolant(const SourceText& source);

}  // namespace feedscope
