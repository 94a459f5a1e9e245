#include "core/program/heidenhain/language/cycle_statements.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/units.h"
#include "core/program/language/statement_table.h"

namespace feedscope::heidenhain {

namespace {

/// Moves after the name of a value, "DIST 2", "V.ZEIT0.5".
void skip_value_name(Scanner& scanner) {
  while (!scanner.at_end()) {
    const char c = scanner.peek();
    const char next = scanner.peek_at(1);
    if (letters::is_digit(c) || c == '+' || c == '-' || (c == '.' && letters::is_digit(next)) ||
        (letters::to_upper(c) == 'Q' &&
         (letters::is_digit(next) || letters::to_upper(next) == 'L' || letters::to_upper(next) == 'R'))) {
      return;
    }
    scanner.move_to(scanner.at() + 1);
  }
}

std::string_view title_of(std::string_view text) {
  const std::size_t parameter = text.find('=');
  std::string_view title = text.substr(0, parameter);
  if (parameter != std::string_view::npos) {
    title = title.substr(0, title.find_last_of("Qq"));
  }
  const std::size_t first = title.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string_view()
                                         : title.substr(first, title.find_last_not_of(' ') + 1 - first);
}

}  // namespace

CycleStatements::CycleStatements(Parts& parts, Words& words, UnsupportedStatements& unsupported)
    : Part(parts.context),
      parts_(parts),
      words_(words),
      unsupported_(unsupported),
      transformations_(parts.context, words, parts.coordinates),
      planes_(parts.context, parts.coordinates),
      pattern_(parts.context, parts.cycle_calls) {}

bool CycleStatements::run(std::string_view name, Scanner& scanner, std::uint32_t column) {
  using P = CycleStatements;
  static constexpr auto statements =
      std::to_array<StatementEntry<P, std::uint32_t>>({{"CYCL", &P::cycle},
                                                       {"CYCLE", &P::cycle},
                                                       {"TRANS", &P::transformation},
                                                       {"PLANE", &P::plane_statement},
                                                       {"PATTERN", &P::pattern},
                                                       {"GLOBAL", &P::global_definition}});
  return run_statement(*this, statements, name, scanner, column);
}

void CycleStatements::transformation(Scanner& scanner, std::uint32_t column) {
  transformations_.run(scanner, column);
}

void CycleStatements::plane_statement(Scanner& scanner, std::uint32_t column) {
  if (!planes_.run(scanner, column)) {
    unsupported_.report_known("PLANE", column);
  }
}

void CycleStatements::pattern(Scanner& scanner, std::uint32_t column) {
  pattern_.run(scanner, column);
}

void CycleStatements::cycle(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("CALL")) {
    call(scanner, column);
    return;
  }
  if (!scanner.take_keyword("DEF")) {
    unsupported_.report_unknown(scanner.text(), column);
    return;
  }
  const auto digits = [&] {
    int value = 0;
    for (scanner.peek(); letters::is_digit(scanner.peek_at(0)); scanner.move_to(scanner.at() + 1)) {
      value = std::min(value * 10 + (scanner.peek_at(0) - '0'), 9999);
    }
    return value;
  };
  const int number = digits();
  if (scanner.take('.')) {
    cycle_line(number, digits(), scanner, column);
  } else {
    parts_.cycles.define(number, title_of(scanner.rest()), scanner, column);
  }
}

void CycleStatements::call(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("PAT")) {
    parts_.cycle_calls.call_at_pattern(words_.read(scanner), column);
  } else if (scanner.take_keyword("POS")) {
    parts_.cycle_calls.call_at(words_.read(scanner), column);
  } else {
    parts_.cycle_calls.call(words_.read(scanner), column);
  }
}

void CycleStatements::global_definition(Scanner& scanner, std::uint32_t column) {
  if (!scanner.take_keyword("DEF")) {
    unsupported_.report_unknown(scanner.text(), column);
    return;
  }
  scanner.skip_digits();
  parts_.cycle_parameters.predefine(scanner);
}

void CycleStatements::cycle_line(int number, int part, Scanner& scanner, std::uint32_t column) {
  constexpr int spindle_orientation = 13;
  if (TransformationStatements::has_cycle(number)) {
    if (part > 0) {
      transformations_.run_cycle(number, scanner, column);
    }
    return;
  }
  switch (number) {
    case 1:
    case 2:
    case 17:
      if (part == 0) {
        parts_.cycles.define_old_drilling(number);
      } else {
        skip_value_name(scanner);
        parts_.cycles.set_old_drilling(number, part, read_value(scanner));
      }
      return;
    case spindle_orientation:
      return;
    case 9:
      if (part > 0) {
        skip_value_name(scanner);
        parts_.dwells.run(read_value(scanner), column);
      }
      return;
    case 12:
      if (part > 0) {
        scanner.take_keyword("PGM");
        parts_.cycles.define_program(scanner.rest());
      }
      return;
    case 19:
      if (part > 0) {
        planes_.run_cycle(scanner, column);
      }
      return;
    case 32:
      tolerance_line(part, scanner, column);
      return;
    default:
      if (part == 0) {
        parts_.cycles.skip(number, title_of(scanner.rest()), column);
      }
      return;
  }
}

void CycleStatements::tolerance_line(int part, Scanner& scanner, std::uint32_t column) {
  if (part == 1) {
    std::optional<double> tolerance;
    if (scanner.take('T') && !scanner.at_end()) {
      tolerance = read_length(scanner);
    }
    parts_.path_modes.set_tolerance(tolerance, std::nullopt, column);
  } else if (part == 2) {
    if (scanner.take("HSC-MODE:")) {
      const double mode = read_value(scanner);
      report(Severity::info, "machining-mode", 0, column, [&] {
        return Text{message(NC_("core", "HSC-MODE {} changes nothing in the simulation"), mode),
                    NC_("core",
                        "its parameters exist only in the control; set acceleration and jerk of the machine "
                        "instead")};
      });
    }
    if (scanner.take("TA")) {
      parts_.path_modes.set_orientation_tolerance(units::from_deg(read_value(scanner)), column);
    }
  }
}

}  // namespace feedscope::heidenhain
