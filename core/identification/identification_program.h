#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/program/dialect.h"

namespace feedscope {

/// A program that a machine runs so that a trace of it tells its limits.
struct IdentificationProgramRequest {
  Dialect dialect = Dialect::iso;
  double size = 200;      ///< of the square in X and Y that it keeps to, 20 to 2000 [mm]
  double feed_max = 250;  ///< largest programmed feed, 100 to 100 000 mm/min [mm/s]
};

/// One part of it, between two pauses.
struct IdentificationProgramPart {
  std::string title;       ///< as the comment in the program has it
  std::string tells;       ///< what a trace of it tells, one sentence
  std::uint32_t line = 0;  ///< of its comment
};

struct IdentificationProgram {
  std::string text;
  std::vector<IdentificationProgramPart> parts;
  std::size_t sections = 0;  ///< whose time can be taken, from 1 on, in the order of the program
  double height = 0;         ///< how far Z goes up from the zero point, where it begins; never below [mm]
};

/// Single moves, ramps, corners of 10 to 170 degrees, circles and short blocks, at several feeds, about the
/// zero point in the middle, Z only upwards from it. Pauses of a quarter of a second part the sections, which
/// comments mark (section_mark()). A Fanuc takes the time of each itself (#3001, in ms, in #101 and on), a
/// SINUMERIK too ($AC_TIMER[1], in s, in R1 and on). Throws InputError naming value and bound, or the dialect
/// if the test program is not written in it.
IdentificationProgram identification_program(const IdentificationProgramRequest& request);

}  // namespace feedscope
