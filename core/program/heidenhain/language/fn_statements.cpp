#include "core/program/heidenhain/language/fn_statements.h"

#include <array>
#include <optional>

#include "core/program/language/statement_table.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

bool FnStatements::run(std::string_view name, Scanner& scanner, std::uint32_t column) {
  static constexpr auto statements = std::to_array<StatementEntry<FnStatements, std::uint32_t>>(
      {{"FN", &FnStatements::function}, {"DECLARE", &FnStatements::declaration}});
  return run_statement(*this, statements, name, scanner, column);
}

void FnStatements::function(Scanner& scanner, std::uint32_t column) {
  constexpr int system_read = 18;
  const std::optional<double> number = scanner.number();
  if (!number || *number > 99) {
    throw_unread_words(scanner, Message::as_written("FN"));
  }
  FunctionCall call;
  call.number = static_cast<int>(*number);
  call.column = column;
  scanner.take(':');
  if (call.jumps()) {
    jump_condition(scanner, call);
  } else if (call.number == system_read) {
    system_data_.read(scanner, column);
    return;
  } else if (call.computes()) {
    arithmetic(scanner, call);
  }
  q_functions_.run(call);
}

void FnStatements::declaration(Scanner& scanner, std::uint32_t /*column*/) {
  scanner.take_keyword("STRING");
  q_functions_.assign(scanner);
}

void FnStatements::arithmetic(Scanner& scanner, FunctionCall& call) const {
  call.result = take_parameter(scanner);
  if (!call.result || call.result->kind == QName::Kind::text || !scanner.take('=')) {
    throw_unread_words(scanner, Message::as_written("FN"));
  }
  constexpr std::array<std::string_view, 3> of_one{"SQRT", "SIN", "COS"};
  if (call.number >= 5 && call.number <= 7) {
    scanner.take_keyword(of_one[static_cast<std::size_t>(call.number - 5)]);
  }
  call.values[0] = read_value(scanner);
  constexpr std::array<std::string_view, 5> of_two{"+", "-", "*", "DIV", "LEN"};
  const std::string_view sign = call.number == 13                      ? "ANG"
                                : call.number >= 1 && call.number <= 4 ? of_two[call.number - 1U]
                                : call.number == 8                     ? of_two[4]
                                                                       : "";
  if (sign.empty()) {
    return;
  }
  if (!scanner.take(sign) && !(call.number == 4 && scanner.take('/'))) {
    throw_unread_words(scanner, Message::as_written("FN"));
  }
  call.values[1] = read_value(scanner);
}

bool FnStatements::definition_condition(Scanner& scanner, FunctionCall& call) const {
  Scanner ahead = scanner;
  ahead.take('+');
  const std::optional<QName> name = take_parameter(ahead);
  if (!name || !ahead.take_keyword("IS")) {
    return false;
  }
  const bool undefined = ahead.take_keyword("UNDEFINED");
  if (!undefined && !ahead.take_keyword("DEFINED")) {
    throw_unread_words(ahead, Message::as_written("FN"));
  }
  const bool is_defined = name->kind == QName::Kind::text ? !parameters().text(name->number).empty()
                                                          : parameters().get(*name).has_value();
  call.number = 9;
  call.values = {is_defined == undefined ? 1.0 : 0.0, 0.0};
  scanner = ahead;
  return true;
}

void FnStatements::jump_condition(Scanner& scanner, FunctionCall& call) const {
  constexpr std::array<std::string_view, 4> relations{"EQU", "NE", "GT", "LT"};
  scanner.take("IF");
  if (!definition_condition(scanner, call)) {
    call.values[0] = read_value(scanner);
    if (!scanner.take(relations[static_cast<std::size_t>(call.number - 9)])) {
      throw_unread_words(scanner, Message::as_written("FN"));
    }
    call.values[1] = read_value(scanner);
  }
  if (!scanner.take("GOTO")) {
    throw_unread_words(scanner, Message::as_written("FN"));
  }
  scanner.take("LBL");
  call.label = labels_.read(scanner);
}

}  // namespace feedscope::heidenhain
