#pragma once

#include <cstdint>

#include "core/program/heidenhain/cycles/cycle_calls.h"

namespace feedscope::heidenhain {

/// The words of one pattern of PATTERN DEF; lengths in mm, angles in degrees.
struct PatternWords {
  double x = 0;
  double y = 0;
  double z = 0;        ///< added to the cycle's surface
  double spacing = 0;  ///< D: of a row, or the circle's diameter
  double column_spacing = 0;
  double row_spacing = 0;
  double count = 0;
  double columns = 0;
  double rows = 0;
  double turn = 0;
  double first_turn = 0;
  double second_turn = 0;
  double start = 0;
  double step = 0;
};

/// PATTERN DEF: places for CYCL CALL PAT.
class PatternStatement : private Part {
 public:
  /// Both outlive it.
  PatternStatement(Context& context, CycleCalls& cycle_calls) : Part(context), cycle_calls_(cycle_calls) {}

  /// Reads from after "PATTERN". Throws ReadFault.
  void run(Scanner& scanner, std::uint32_t column);

 private:
  PatternWords read_words(Scanner& scanner) const;

  CycleCalls& cycle_calls_;
};

}  // namespace feedscope::heidenhain
