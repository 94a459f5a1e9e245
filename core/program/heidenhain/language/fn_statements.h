#pragma once

#include <cstdint>
#include <string_view>

#include "core/program/heidenhain/language/labels.h"
#include "core/program/heidenhain/language/q_functions.h"
#include "core/program/heidenhain/language/system_data.h"

namespace feedscope::heidenhain {

/// FN 0 to FN 99 in conversational form, and DECLARE STRING.
class FnStatements : private Part {
 public:
  /// All outlive it.
  FnStatements(Context& context, const Labels& labels, QFunctions& q_functions, SystemData& system_data)
      : Part(context), labels_(labels), q_functions_(q_functions), system_data_(system_data) {}

  /// Returns false for any other name. Throws ReadFault.
  bool run(std::string_view name, Scanner& scanner, std::uint32_t column);

 private:
  void function(Scanner& scanner, std::uint32_t column);
  void declaration(Scanner& scanner, std::uint32_t column);
  void arithmetic(Scanner& scanner, FunctionCall& call) const;
  void jump_condition(Scanner& scanner, FunctionCall& call) const;
  /// Reads "Q1 IS UNDEFINED" as a condition; false, with nothing taken, if it is not next.
  bool definition_condition(Scanner& scanner, FunctionCall& call) const;

  const Labels& labels_;
  QFunctions& q_functions_;
  SystemData& system_data_;
};

}  // namespace feedscope::heidenhain
