#pragma once

#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/language/assignments.h"
#include "core/program/sinumerik/language/jumps.h"
#include "core/program/sinumerik/language/program_indexes.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Control structures: IF, FOR, WHILE, LOOP, REPEAT ... UNTIL, and their ends.
class Flow : private Part {
 public:
  /// All outlive it.
  Flow(Context& context, Values& values, Assignments& assignments, ProgramIndexes& indexes, Jumps& jumps)
      : Part(context), values_(values), assignments_(assignments), indexes_(indexes), jumps_(jumps) {}

  /// Runs the statement `name`, which has just been read; false if it is not one of this part. Throws
  /// ReadFault.
  bool run(std::string_view name, Scanner& scanner);

 private:
  ProgramIndex::Structure structure(Scanner& scanner, std::string_view word);
  void run_if(Scanner& scanner);
  void run_else(Scanner& scanner);
  void run_endif(Scanner& scanner);
  void run_for(Scanner& scanner);
  void run_endfor(Scanner& scanner);
  void run_while(Scanner& scanner);
  void run_loop(Scanner& scanner);
  void run_endwhile(Scanner& scanner);
  void run_endloop(Scanner& scanner);
  void run_repeat(Scanner& scanner);
  void run_until(Scanner& scanner);

  Values& values_;
  Assignments& assignments_;
  ProgramIndexes& indexes_;
  Jumps& jumps_;
};

}  // namespace feedscope::sinumerik
