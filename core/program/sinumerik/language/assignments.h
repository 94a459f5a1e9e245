#pragma once

#include <cstddef>
#include <string_view>

#include "core/program/sinumerik/language/values.h"
#include "core/program/sinumerik/language/variables.h"

namespace feedscope::sinumerik {

/// Counter of FOR: an R parameter or an element of a variable.
struct LoopCounter {
  int r = -1;
  Variable* variable = nullptr;  ///< used if `r` is negative
  std::size_t element = 0;
};

/// Assigns values to variables: single ones, and lists to arrays by SET and REP.
class Assignments {
 public:
  /// `values` outlives it.
  explicit Assignments(Values& values) : values_(values) {}

  /// Reads one or more assignments to a variable after its name: index, "=" and the value. Throws ReadFault.
  void assign(Scanner& scanner, Variable& variable, std::string_view name);
  /// The same for an R parameter after its "R": "5=1", "[5]=1". False, with nothing taken, if no number is
  /// next. Throws ReadFault.
  bool assign_r(Scanner& scanner);
  /// Values after DEF's "=": one, or a list in brackets. Throws ReadFault.
  void initialise(Scanner& scanner, Variable& variable);

  /// Throws ReadFault "syntax" if no variable is next.
  LoopCounter read_counter(Scanner& scanner);
  double get(const LoopCounter& counter) const;
  void set(const LoopCounter& counter, double value);

 private:
  void set_list(Scanner& scanner, Variable& variable, std::size_t first);
  void repeat_one(Scanner& scanner, Variable& variable, std::size_t first);
  static void copy_on(Variable& variable, std::size_t first, double count);
  void set_one(Scanner& scanner, Variable& variable, std::size_t index);

  Values& values_;
};

}  // namespace feedscope::sinumerik
