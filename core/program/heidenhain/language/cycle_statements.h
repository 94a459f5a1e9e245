#pragma once

#include <cstdint>
#include <string_view>

#include "core/program/heidenhain/language/parts.h"
#include "core/program/heidenhain/language/pattern_statement.h"
#include "core/program/heidenhain/language/plane_statements.h"
#include "core/program/heidenhain/language/transformation_statements.h"
#include "core/program/heidenhain/language/unsupported_statements.h"
#include "core/program/heidenhain/language/words.h"

namespace feedscope::heidenhain {

/// Definitions and calls of cycles: CYCL DEF, CYCL CALL, GLOBAL DEF, and the statements of newer controls in
/// place of cycles: TRANS, PLANE, PATTERN DEF.
class CycleStatements : private Part {
 public:
  /// All outlive it.
  CycleStatements(Parts& parts, Words& words, UnsupportedStatements& unsupported);

  /// Returns false for any other name. Throws ReadFault.
  bool run(std::string_view name, Scanner& scanner, std::uint32_t column);

 private:
  void cycle(Scanner& scanner, std::uint32_t column);
  void call(Scanner& scanner, std::uint32_t column);
  void global_definition(Scanner& scanner, std::uint32_t column);
  void transformation(Scanner& scanner, std::uint32_t column);
  void plane_statement(Scanner& scanner, std::uint32_t column);
  void pattern(Scanner& scanner, std::uint32_t column);
  /// "CYCL DEF 9.1 DWELL2": line `part` of cycle `number`.
  void cycle_line(int number, int part, Scanner& scanner, std::uint32_t column);
  void tolerance_line(int part, Scanner& scanner, std::uint32_t column);

  Parts& parts_;
  Words& words_;
  UnsupportedStatements& unsupported_;
  TransformationStatements transformations_;
  PlaneStatements planes_;
  PatternStatement pattern_;
};

}  // namespace feedscope::heidenhain
