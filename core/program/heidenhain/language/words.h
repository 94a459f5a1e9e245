#pragma once

#include <cstdint>

#include "core/program/heidenhain/language/m_functions.h"

namespace feedscope::heidenhain {

/// Reads the words of conversational blocks: "X+10 IY-5 R0 FMAX M3".
class Words : private Part {
 public:
  /// Both outlive it.
  Words(Context& context, const MFunctions& m_functions) : Part(context), m_functions_(m_functions) {}

  /// Reads all words up to the end of the statement. Throws ReadFault.
  MotionWords read(Scanner& scanner);

 private:
  /// Returns false, with nothing consumed, if the letter is not a word.
  bool read_word(Scanner& scanner, char letter, std::uint32_t column, MotionWords& words);
  bool read_axis(Scanner& scanner, char letter, bool incremental, std::uint32_t column, MotionWords& words);
  bool read_normal(Scanner& scanner, char kind, std::uint32_t column, MotionWords& words);
  void read_feed(Scanner& scanner, std::uint32_t column, MotionWords& words);
  void read_radius(Scanner& scanner, std::uint32_t column, MotionWords& words);

  const MFunctions& m_functions_;
};

}  // namespace feedscope::heidenhain
