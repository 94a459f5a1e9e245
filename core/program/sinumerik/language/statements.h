#pragma once

#include <cstdint>
#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/compensation.h"
#include "core/program/sinumerik/geometry/other_axis_words.h"
#include "core/program/sinumerik/geometry/path_modes.h"
#include "core/program/sinumerik/geometry/polynomials.h"
#include "core/program/sinumerik/geometry/positioning_axes.h"
#include "core/program/sinumerik/language/addresses.h"
#include "core/program/sinumerik/language/assignments.h"
#include "core/program/sinumerik/language/calls.h"
#include "core/program/sinumerik/language/definitions.h"
#include "core/program/sinumerik/language/flow.h"
#include "core/program/sinumerik/language/frame_variables.h"
#include "core/program/sinumerik/language/jumps.h"
#include "core/program/sinumerik/language/modal_words.h"
#include "core/program/sinumerik/language/repeats.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Reads lines with more than letters with plain numbers: identifies each item and runs it by its part.
class Statements : private Part {
 public:
  /// Parts that run the statements; all outlive it.
  struct Parts {
    Values& values;
    Assignments& assignments;
    ModalWords& modal_words;
    Addresses& addresses;
    PathModes& path_modes;
    Compensation& compensation;
    FrameVariables& frame_variables;
    OtherAxisWords& other_axes;
    Polynomials& polynomials;
    PositioningAxes& positioning_axes;
    Definitions& definitions;
    Jumps& jumps;
    Repeats& repeats;
    Flow& flow;
    Calls& calls;
  };
  Statements(Context& context, const Parts& parts) : Part(context), parts_(parts) {}

  /// Runs from the first item that is not a plain word to the line's end, after the plain words. Throws
  /// ReadFault.
  void run(Scanner& scanner);

 private:
  void run_item(Scanner& scanner);
  void run_word(Scanner& scanner);
  void run_letter(Scanner& scanner);
  void run_name(Scanner& scanner);
  void run_system_variable(Scanner& scanner);
  bool run_assignment(Scanner& scanner, std::string_view name);
  bool run_statement(std::string_view name, Scanner& scanner);
  bool run_synchronized(std::string_view name, Scanner& scanner);
  bool run_function(std::string_view name, std::uint32_t column, Scanner& scanner);
  bool run_value(std::string_view name, std::uint32_t column, Scanner& scanner);

  Parts parts_;
};

}  // namespace feedscope::sinumerik
