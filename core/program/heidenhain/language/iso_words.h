#pragma once

#include <cstdint>

#include "core/program/heidenhain/cycles/cycles.h"
#include "core/program/heidenhain/language/iso_block.h"
#include "core/program/heidenhain/language/m_functions.h"

namespace feedscope::heidenhain {

/// Takes a whole number without sign, at most 99999; 0 if no digit is next.
int take_digits(Scanner& scanner);

/// Reads the words of DIN/ISO blocks.
class IsoWords : private Part {
 public:
  /// All outlive it.
  IsoWords(Context& context, const Labels& labels, const Tools& tools, const MFunctions& m_functions,
           Cycles& cycles)
      : Part(context), labels_(labels), tools_(tools), m_functions_(m_functions), cycles_(cycles) {}

  /// Returns false if the definition of a cycle has taken the rest of the block. `incremental`: G91 is in
  /// force. Throws ReadFault.
  bool read(Scanner& scanner, bool incremental, IsoBlock& block);
  /// Reads "5", "5,3" or a name after the L. Throws ReadFault.
  void read_label(Scanner& scanner, IsoBlock& block) const;

 private:
  bool read_word(Scanner& scanner, bool incremental, IsoBlock& block);
  bool read_code(Scanner& scanner, std::uint32_t column, IsoBlock& block);
  void read_tool(Scanner& scanner, IsoBlock& block) const;
  void read_tool_excess(Scanner& scanner, IsoBlock& block) const;
  void read_value_of_cycle(Scanner& scanner, IsoBlock& block) const;
  void read_coordinate(Scanner& scanner, char letter, bool incremental, IsoBlock& block) const;
  void read_feed(Scanner& scanner, MotionWords& words) const;

  const Labels& labels_;
  const Tools& tools_;
  const MFunctions& m_functions_;
  Cycles& cycles_;
};

}  // namespace feedscope::heidenhain
