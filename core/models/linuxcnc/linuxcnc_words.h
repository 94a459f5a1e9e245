#pragma once

#include <cstdint>
#include <limits>

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
  /// Of the lines behind segment `i` - 1 up to that of segment `i`; to be asked in rising order. Where words
  /// that lead elsewhere stand between them, as O words, WHILE or M98: up to the first of them, and behind
  /// the last one before segment `i`. Where the program goes back to a line that no beginning of a loop or
  /// subprogram stands above, of that line alone. Linear in the lines that are run.
  Found before(std::size_t i);

 private:
  void take(std::uint32_t first, std::uint32_t last, Found& all) const;
  void go_back_to(std::uint32_t line, Found& all);

  const Toolpath& toolpath_;
  std::uint32_t line_ = 0;        ///< up to which lines are read
  std::uint32_t without_to_ = 0;  ///< lines 1 to this lead nowhere else
  std::uint32_t without_from_ = std::numeric_limits<std::uint32_t>::max();  ///< nor does any from this one on
};

/// Whether a line has M7, M8 or M9.
bool switches_coolant(const SourceText& source);

}  // namespace feedscope
