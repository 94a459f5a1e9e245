#pragma once

#include <cstddef>
#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/language/assignments.h"
#include "core/program/sinumerik/language/calls.h"
#include "core/program/sinumerik/language/frame_variables.h"
#include "core/program/sinumerik/language/macros.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Defines variables, parameters and macros: DEF, PROC, EXTERN, DEFINE.
class Definitions : private Part {
 public:
  /// All outlive it.
  Definitions(Context& context, Values& values, Assignments& assignments, FrameVariables& frames,
              Macros& macros, Calls& calls)
      : Part(context),
        values_(values),
        assignments_(assignments),
        frames_(frames),
        macros_(macros),
        calls_(calls) {}

  /// Runs the statement `name`, which has just been read; false if it is not one of this part. Throws
  /// ReadFault.
  bool run(std::string_view name, Scanner& scanner);

 private:
  void run_def(Scanner& scanner);
  void run_define(Scanner& scanner);
  void run_extern(Scanner& scanner);
  void run_proc(Scanner& scanner);
  void read_parameter(Scanner& scanner, std::size_t position);
  const Argument* argument(std::size_t position);
  Variable parameter_variable(Scanner& scanner, Type type, std::string_view name, const Argument* passed);

  Values& values_;
  Assignments& assignments_;
  FrameVariables& frames_;
  Macros& macros_;
  Calls& calls_;
};

}  // namespace feedscope::sinumerik
