#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/language/program_indexes.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Jumps to labels and block numbers: GOTO, GOTOF, GOTOB, GOTOC, GOTOS, and CASE.
class Jumps : private Part {
 public:
  /// All outlive it.
  Jumps(Context& context, Values& values, Splines& splines, ProgramIndexes& indexes)
      : Part(context), values_(values), splines_(splines), indexes_(indexes) {}

  /// Runs the statement `name`, which has just been read; false if it is not one of this part. Throws
  /// ReadFault.
  bool run(std::string_view name, Scanner& scanner);
  /// Reads GOTOF and similar after a condition; jumps if `holds`. False, with nothing taken, if something
  /// else follows. Throws ReadFault.
  bool jump_if(Scanner& scanner, bool holds);
  /// Reads a label, written or as a text. Throws ReadFault.
  std::string label(Scanner& scanner);

 private:
  struct Jump {
    std::string_view name;
    bool forward = false;
    bool backward = false;
    bool must = true;  ///< a missing label is a fault
  };

  static const Jump* find(std::string_view name);
  void go(const Jump& jump, Scanner& scanner);
  void run_case(Scanner& scanner);

  Values& values_;
  Splines& splines_;
  ProgramIndexes& indexes_;
};

}  // namespace feedscope::sinumerik
