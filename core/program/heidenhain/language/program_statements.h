#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/program/heidenhain/language/parts.h"
#include "core/program/heidenhain/language/unsupported_statements.h"
#include "core/program/heidenhain/language/words.h"

namespace feedscope::heidenhain {

/// Statements around the path: BEGIN and END, BLK FORM, TOOL, LBL, CALL, SEL, STOP, PRESET, FUNCTION.
class ProgramStatements : private Part {
 public:
  /// All outlive it.
  ProgramStatements(Parts& parts, Words& words, UnsupportedStatements& unsupported)
      : Part(parts.context), parts_(parts), words_(words), unsupported_(unsupported) {}

  /// Returns false for any other name. Throws ReadFault.
  bool run(std::string_view name, Scanner& scanner, std::uint32_t column);

 private:
  void begin(Scanner& scanner, std::uint32_t column);
  void end(Scanner& scanner, std::uint32_t column);
  void blank_form(Scanner& scanner, std::uint32_t column);
  void tool(Scanner& scanner, std::uint32_t column);
  void tool_definition(Scanner& scanner);
  void tool_call(Scanner& scanner);
  void label(Scanner& scanner, std::uint32_t column);
  void call(Scanner& scanner, std::uint32_t column);
  void stop(Scanner& scanner, std::uint32_t column);
  void tool_centre_point(Scanner& scanner, std::uint32_t column);
  void function(Scanner& scanner, std::uint32_t column);
  void preset(Scanner& scanner, std::uint32_t column);
  void select(Scanner& scanner, std::uint32_t column);

  Parts& parts_;
  Words& words_;
  UnsupportedStatements& unsupported_;
  std::string selected_program_;  ///< SEL PGM
};

}  // namespace feedscope::heidenhain
