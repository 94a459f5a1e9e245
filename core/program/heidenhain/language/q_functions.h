#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/program/heidenhain/language/calls.h"

namespace feedscope::heidenhain {

/// FN or D with its operands.
struct FunctionCall {
  int number = 0;
  std::uint32_t column = 0;
  std::optional<QName> result;  ///< 0 to 8 and 13 have one
  std::array<double, 2> values{};
  std::string label;  ///< of the jumps 9 to 12

  bool jumps() const { return number >= 9 && number <= 12; }
  bool computes() const { return number <= 8 || number == 13; }
};

/// Assigns Q parameters by formulas and FN functions, and jumps where these compare.
class QFunctions : private Part {
 public:
  /// All outlive it.
  QFunctions(Context& context, Calls& calls) : Part(context), calls_(calls) {}

  /// Reads "Q1 = ..." from the name on. Throws ReadFault.
  void assign(Scanner& scanner);
  /// Throws ReadFault.
  void run(const FunctionCall& call);

 private:
  /// FN 14 and the functions without effect on the path.
  void note(int number, std::uint32_t column);

  Calls& calls_;
};

}  // namespace feedscope::heidenhain
