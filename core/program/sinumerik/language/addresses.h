#pragma once

#include <cstdint>
#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/compensation.h"
#include "core/program/sinumerik/geometry/other_axis_words.h"
#include "core/program/sinumerik/language/assignments.h"
#include "core/program/sinumerik/language/calls.h"
#include "core/program/sinumerik/language/modal_words.h"
#include "core/program/sinumerik/language/values.h"
#include "core/program/text/lexer.h"

namespace feedscope::sinumerik {

/// Reads letters and addresses with their values ("X10", "X=R1", "CR=5", "S1=1000") and passes them on: to
/// the words of the block, G and M to ModalWords, L to Calls.
class Addresses : private Part {
 public:
  /// Receivers of the words; all outlive it.
  struct Parts {
    Values& values;
    Assignments& assignments;
    ModalWords& modal_words;
    Compensation& compensation;
    Calls& calls;
    OtherAxisWords& other_axes;
  };
  Addresses(Context& context, const Parts& parts) : Part(context), parts_(parts) {}

  /// A letter with a plain number; `written`: both.
  void set(const Word& word, std::string_view written);
  /// Reads a letter with a number after it, with "=" and a value, or with an index. False, with nothing
  /// taken, for everything else. Throws ReadFault.
  bool run_letter(Scanner& scanner);
  /// Reads "CR=5" after its `name` in `column`. False, with nothing taken, if it is not an address. Throws
  /// ReadFault.
  bool run_address(Scanner& scanner, std::string_view name, std::uint32_t column);
  /// The same for a letter with a number, "I1=", "S2=", "Z1=", which is an axis if it is nothing else.
  void run_numbered(Scanner& scanner, std::string_view name, std::uint32_t column);

 private:
  void set(char letter, const BlockWords::Value& value, std::string_view written);
  void set_call(const BlockWords::Value& value, std::string_view written);

  Parts parts_;
};

}  // namespace feedscope::sinumerik
