#include "core/program/heidenhain/language/path_statements.h"

#include <array>

#include "core/program/language/statement_table.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

/// Kind of an APPR or DEP, and true if the point is polar. Throws ReadFault.
std::pair<ApproachKind, bool> approach_name(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  std::string_view name = scanner.name();
  const bool polar = !name.empty() && letters::to_upper(name.front()) == 'P';
  name.remove_prefix(polar ? 1 : 0);
  constexpr std::array<std::string_view, 4> names{"LT", "LN", "CT", "LCT"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (letters::same(name, names[i])) {
      return {static_cast<ApproachKind>(i), polar};
    }
  }
  throw ReadFault{"approach", column,
                  message(NC_("core", "{} is not an approach or departure"), in_quotes(name)),
                  NC_("core", "it is skipped; write LT, LN, CT, LCT or the polar forms with P before them")};
}

}  // namespace

bool PathStatements::run(std::string_view name, Scanner& scanner, std::uint32_t column) {
  using P = PathStatements;
  static constexpr auto statements =
      std::to_array<StatementEntry<P, std::uint32_t>>({{"L", &P::line},
                                                       {"CC", &P::pole},
                                                       {"C", &P::center_arc},
                                                       {"CR", &P::radius_arc},
                                                       {"CT", &P::tangent_arc},
                                                       {"LP", &P::polar_line},
                                                       {"CP", &P::polar_arc},
                                                       {"CTP", &P::polar_tangent_arc},
                                                       {"LN", &P::line},
                                                       {"RND", &P::rounding},
                                                       {"CHF", &P::chamfer},
                                                       {"APPR", &P::approach},
                                                       {"DEP", &P::departure}});
  return run_statement(*this, statements, name, scanner, column);
}

void PathStatements::line(Scanner& scanner, std::uint32_t /*column*/) {
  motions_.run(PathKind::line, words_.read(scanner));
}

void PathStatements::pole(Scanner& scanner, std::uint32_t /*column*/) {
  targets_.set_pole(words_.read(scanner));
}

void PathStatements::center_arc(Scanner& scanner, std::uint32_t column) {
  run_curve(PathKind::center_arc, scanner, column);
}

void PathStatements::radius_arc(Scanner& scanner, std::uint32_t column) {
  run_curve(PathKind::radius_arc, scanner, column);
}

void PathStatements::tangent_arc(Scanner& scanner, std::uint32_t column) {
  run_curve(PathKind::tangent_arc, scanner, column);
}

void PathStatements::polar_line(Scanner& scanner, std::uint32_t column) {
  run_curve(PathKind::polar_line, scanner, column);
}

void PathStatements::polar_arc(Scanner& scanner, std::uint32_t column) {
  run_curve(PathKind::polar_arc, scanner, column);
}

void PathStatements::polar_tangent_arc(Scanner& scanner, std::uint32_t column) {
  run_curve(PathKind::polar_tangent_arc, scanner, column);
}

void PathStatements::run_curve(PathKind kind, Scanner& scanner, std::uint32_t column) {
  MotionWords words = words_.read(scanner);
  words.first_column = words.first_column == 0 ? column : words.first_column;
  motions_.run(kind, words);
}

void PathStatements::rounding(Scanner& scanner, std::uint32_t column) {
  const MotionWords words = words_.read(scanner);
  if (!words.radius) {
    throw ReadFault{"corner", column, NC_("core", "RND without a radius R"),
                    NC_("core", "the corner stays sharp")};
  }
  motions_.run_corner(true, *words.radius, words, column);
}

void PathStatements::chamfer(Scanner& scanner, std::uint32_t column) {
  const double side = read_length(scanner);
  motions_.run_corner(false, side, words_.read(scanner), column);
}

void PathStatements::approach(Scanner& scanner, std::uint32_t column) {
  const auto [kind, polar] = approach_name(scanner);
  approaches_.approach(kind, polar, words_.read(scanner), column);
}

void PathStatements::departure(Scanner& scanner, std::uint32_t column) {
  const auto [kind, polar] = approach_name(scanner);
  approaches_.depart(kind, polar, words_.read(scanner), column);
}

}  // namespace feedscope::heidenhain
