#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/language/jumps.h"
#include "core/program/sinumerik/language/program_indexes.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Repeats parts of the program: REPEAT with labels, REPEATB.
class Repeats : private Part {
 public:
  /// All outlive it.
  Repeats(Context& context, Values& values, Splines& splines, ProgramIndexes& indexes, Jumps& jumps)
      : Part(context), values_(values), splines_(splines), indexes_(indexes), jumps_(jumps) {}

  /// Runs the statement `name`, which has just been read; false if it is not one of this part, or if it is
  /// REPEAT without a label, which begins a loop. Throws ReadFault.
  bool run(std::string_view name, Scanner& scanner);
  /// True if line `next` is after the repeated part: it runs again, or the program continues after the
  /// statement.
  bool is_over(std::uint32_t next);
  /// Ends the repeats of a subprogram that was left.
  void leave_call();

 private:
  struct Repeat {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;     ///< last line that runs
    std::uint32_t resume = 0;  ///< line after the statement
    std::uint32_t left = 0;    ///< runs, including this one
    std::size_t depth = 0;     ///< of calls
  };

  void run_part(Scanner& scanner);
  void run_line(Scanner& scanner);
  void add(std::uint32_t begin, std::uint32_t end, Scanner& scanner);
  std::uint32_t label_line(Scanner& scanner, std::uint32_t column);
  std::uint32_t count(Scanner& scanner);

  Values& values_;
  Splines& splines_;
  ProgramIndexes& indexes_;
  Jumps& jumps_;
  std::vector<Repeat> repeats_;  ///< innermost last
};

}  // namespace feedscope::sinumerik
