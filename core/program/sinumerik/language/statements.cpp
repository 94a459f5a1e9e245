#include "core/program/sinumerik/language/statements.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/program/sinumerik/geometry/coordinate_value.h"
#include "core/program/sinumerik/language/names.h"
#include "core/program/sinumerik/language/scanning.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

namespace {

[[noreturn]] void throw_unknown(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  throw ReadFault{"syntax", column,
                  message(NC_("core", "{} does not start a word or statement"), in_quotes(scanner.rest())),
                  NC_("core", "the rest of the line is skipped and the block does not move; correct it")};
}

}  // namespace

void Statements::run(Scanner& scanner) {
  // Colon before the block number, or a label without one.
  if (scanner.take(':') && !scanner.number()) {
    throw_unknown(scanner);
  }
  while (!scanner.at_end()) {
    run_item(scanner);
  }
}

void Statements::run_item(Scanner& scanner) {
  const char next = scanner.peek();
  if (next == '$') {
    run_system_variable(scanner);
    return;
  }
  if (!letters::is_letter(next) && next != '_') {
    throw_unknown(scanner);
  }
  const char second = scanner.peek_at(1);
  if (next == '_' || letters::is_letter(second) || second == '_') {
    run_name(scanner);
  } else if (letters::is_digit(second)) {
    run_word(scanner);
  } else {
    run_letter(scanner);
  }
}

void Statements::run_system_variable(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  scanner.take('$');
  const std::string name = upper_case(scanner.name());
  if (name == "TC_DP6") {
    parts_.compensation.set_tool_radius(scanner);
    return;
  }
  if (parts_.frame_variables.run_system_variable(scanner, name)) {
    return;
  }
  if (is_timer(name)) {
    parts_.values.skip(scanner);
    return;
  }
  const bool frame = name.find("FR") != std::string::npos || name == "TC_DP15";
  report(frame ? Severity::error : Severity::info, "system-variable", kind_of(name), column, [&] {
    return Text{
        message(NC_("core", "assignment to {} is not supported"), feedscope::in_quotes("$" + name)),
        frame ? NC_("core", "the path is shown without it") : NC_("core", "the path does not change")};
  });
  parts_.values.skip(scanner);
}

/// "X10", "G641", or an address with a number, "I1=".
void Statements::run_word(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  Scanner behind = scanner;
  const std::string_view name = behind.name();
  const char after = behind.peek();
  if (letters::to_upper(name[0]) == 'R' && (after == '=' || after == '[')) {
    scanner.take('R');
    if (!parts_.assignments.assign_r(scanner)) {
      throw_unknown(scanner);
    }
  } else if (after == '=' || after == '[') {
    scanner = behind;
    if (!run_assignment(scanner, name)) {
      parts_.addresses.run_numbered(scanner, name, column);
    }
  } else {
    run_letter(scanner);
  }
}

void Statements::run_letter(Scanner& scanner) {
  if (!parts_.addresses.run_letter(scanner)) {
    throw_unknown(scanner);
  }
}

void Statements::run_name(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const std::size_t from = scanner.at();
  const std::string_view name = scanner.name();
  const char after = scanner.peek();
  if (after == ':') {
    scanner.take(':');
    return;
  }
  if (run_assignment(scanner, name)) {
    return;
  }
  if (after == '=' &&
      (parts_.addresses.run_address(scanner, name, column) || parts_.path_modes.run(scanner, name, column))) {
    return;
  }
  if (run_statement(name, scanner) || run_function(name, column, scanner) ||
      run_value(name, column, scanner)) {
    return;
  }
  scanner.move_to(from);
  parts_.calls.read(scanner);
}

/// Assigns to a variable of DEF.
bool Statements::run_assignment(Scanner& scanner, std::string_view name) {
  Variable* const variable = parts_.values.variables().find(name);
  const char after = scanner.peek();
  if (variable != nullptr && (after == '=' || after == '[')) {
    parts_.assignments.assign(scanner, *variable, name);
    return true;
  }
  return parts_.frame_variables.run_assignment(scanner, name);
}

bool Statements::run_statement(std::string_view name, Scanner& scanner) {
  return parts_.repeats.run(name, scanner) || parts_.flow.run(name, scanner) ||
         parts_.jumps.run(name, scanner) || parts_.definitions.run(name, scanner) ||
         parts_.calls.run(name, scanner) || parts_.polynomials.run(name, scanner) ||
         parts_.positioning_axes.run(name, scanner) || run_synchronized(name, scanner);
}

bool Statements::run_synchronized(std::string_view name, Scanner& scanner) {
  constexpr auto beginnings =
      std::to_array<std::string_view>({"WHEN", "WHENEVER", "EVERY", "FROM", "DO", "ID", "IDS"});
  if (std::none_of(beginnings.begin(), beginnings.end(),
                   [&](std::string_view known) { return letters::same(known, name); })) {
    return false;
  }
  report(Severity::info, "synchronized-action", 0, scanner.column(), [] {
    return Text{NC_("core", "a synchronized action is not supported"),
                NC_("core", "the path does not change")};
  });
  skip_rest(scanner);
  return true;
}

bool Statements::run_function(std::string_view name, std::uint32_t column, Scanner& scanner) {
  const Function* const function = find_function(name);
  if (function == nullptr) {
    return false;
  }
  parts_.modal_words.apply(*function, column);
  if (function->action == Action::polynomial || function->action == Action::accept ||
      function->action == Action::report) {
    parts_.values.skip(scanner);
  }
  return true;
}

/// "FP=2", "A3=0.5", and values of unknown names.
bool Statements::run_value(std::string_view name, std::uint32_t column, Scanner& scanner) {
  const char after = scanner.peek();
  if (after != '=' && after != '[') {
    return false;
  }
  if (after == '=' && functions_.machine_axes != nullptr && letters::same(name, "FP")) {
    constexpr double max_point = 1000;
    scanner.take('=');
    const double point = read_coordinate(parts_.values, scanner, column).value;
    functions_.fixed_point = static_cast<int>(std::clamp(point, 0.0, max_point));
  } else if (after == '=' && OtherAxisWords::is_orientation(name)) {
    scanner.take('=');
    parts_.other_axes.move(name, read_coordinate(parts_.values, scanner, column));
  } else {
    report(Severity::error, "unknown-name", kind_of(name), column, [&] {
      return Text{message(NC_("core", "{} is not a known variable, address or axis"), in_quotes(name)),
                  NC_("core", "its value is ignored; define a variable by DEF before it is used")};
    });
    parts_.values.skip(scanner);
  }
  return true;
}

}  // namespace feedscope::sinumerik
