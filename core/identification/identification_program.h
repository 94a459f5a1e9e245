#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/program/dialect.h"

namespace feedscope {

/// A program to be run and recorded for the identification of a machine's limits.
struct IdentificationProgramRequest {
  Dialect dialect = Dialect::iso;
  double size = 200;      ///< of the square in X and Y that contains it, 20 to 2000 [mm]
  double feed_max = 250;  ///< largest programmed feed, 100 to 100 000 mm/min [mm/s]
};

/// A part between two pauses.
struct IdentificationProgramPart {
  std::string title;       ///< as in the program's comment
  std::string tells;       ///< numbers that a trace of it determines, one sentence
  std::uint32_t line = 0;  ///< of its comment
};

struct IdentificationProgram {
  std::string text;
  std::vector<IdentificationProgramPart> parts;
  std::size_t sections = 0;  ///< timed ones, numbered from 1 in the order of the program
  double height = 0;         ///< rise of Z above the zero point, where it begins; it never goes below [mm]
};

/// Writes single moves, ramps, corners of 10 to 170 degrees, circles and short blocks, at several feeds,
/// around the zero point, with Z only upwards from it. Pauses of a quarter of a second separate the sections,
/// which comments mark (section_mark()). A Fanuc times each section itself (#3001, in ms, from #101 on), so
/// does a SINUMERIK ($AC_TIMER[1], in s, from R1 on). Throws InputError with value and bound, or with the
/// dialect if there is no test program for it.
IdentificationProgram identification_program(const IdentificationProgramRequest& request);

}  // namespace feedscope
