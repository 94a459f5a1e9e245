#include "core/program/heidenhain/reader.h"

namespace feedscope::heidenhain {

namespace {

/// Moves after the number of the block and the sign that hides it; true if it is hidden.
bool skip_line_number(Scanner& scanner) {
  const bool before = scanner.take('/');
  if (letters::to_upper(scanner.peek()) == 'N' && letters::is_digit(scanner.peek_at(1))) {
    scanner.take('N');
  }
  scanner.skip_digits();
  const bool behind = scanner.take('/');
  scanner.peek();
  return before || behind;
}

/// True for an empty line, a heading, or a line of a setup sheet that a CAM system put before the program.
bool is_no_block(Scanner& scanner) {
  return scanner.at_end() || scanner.peek() == '*' || scanner.peek() == '(';
}

std::string_view keyword(Scanner& scanner) {
  scanner.peek();
  const std::size_t from = scanner.at();
  std::size_t length = 0;
  while (letters::is_letter(scanner.peek_at(length))) {
    ++length;
  }
  scanner.move_to(from + length);
  return scanner.text().substr(from, length);
}

bool is_parameter_name(std::string_view name, char after) {
  return letters::is_digit(after) && (letters::same(name, "Q") || letters::same(name, "QL") ||
                                      letters::same(name, "QR") || letters::same(name, "QS"));
}

/// True for words of a block without a name: "X+50 R+ FMAX", "IZ-5", "M3", "F500".
bool starts_words(std::string_view name) {
  constexpr std::string_view first = "XYZABCUVWIMFR";
  return name.size() <= 2 && first.find(letters::to_upper(name.front())) != std::string_view::npos;
}

}  // namespace

HeidenhainReader::HeidenhainReader(std::shared_ptr<const SourceText> source, const ReadOptions& options,
                                   Progress* progress)
    : StatementReader(std::move(source), options, progress, Dialect::heidenhain,
                      [this](std::string_view line) { return label_on(line); }),
      words_(parts().context, parts().m_functions),
      unsupported_(parts().context),
      path_statements_(parts().context, words_, parts().targets, parts().motions, parts().approaches),
      program_statements_(parts(), words_, unsupported_),
      fn_statements_(parts().context, parts().labels, parts().q_functions, parts().system_data),
      cycle_statements_(parts(), words_, unsupported_) {}

void HeidenhainReader::run_statement(std::string_view statement) {
  Scanner scanner(statement);
  const bool hidden = skip_line_number(scanner);
  if (is_no_block(scanner) || (hidden && options().skip_deleted_blocks)) {
    return;
  }
  lines().count_block();
  const std::size_t start = scanner.at();
  const std::uint32_t column = scanner.column();
  const std::string_view name = keyword(scanner);
  if (name.empty()) {
    unsupported_.report_unknown(statement, column);
  } else if (!path_statements_.run(name, scanner, column) &&
             !program_statements_.run(name, scanner, column) && !fn_statements_.run(name, scanner, column) &&
             !cycle_statements_.run(name, scanner, column)) {
    run_words(name, start, scanner, column);
  }
}

/// Runs a block that does not begin with the name of a statement.
void HeidenhainReader::run_words(std::string_view name, std::size_t start, Scanner& scanner,
                                 std::uint32_t column) {
  if (is_parameter_name(name, scanner.peek_at(0))) {
    scanner.move_to(start);
    parts().q_functions.assign(scanner);
  } else if (unsupported_.report_known(name, column)) {
    // It is reported.
  } else if (starts_words(name)) {
    scanner.move_to(start);
    path_statements_.line(scanner, column);
  } else {
    unsupported_.report_unknown(scanner.text(), column);
  }
}

std::uint32_t HeidenhainReader::first_word(std::string_view line) {
  Scanner scanner(line.substr(0, line.find(';')));
  skip_line_number(scanner);
  const std::uint32_t column = scanner.column();
  const bool counts = !is_no_block(scanner) && !letters::same(keyword(scanner), "END");
  return counts ? column : 0;
}

std::string HeidenhainReader::label_on(std::string_view line) {
  Scanner scanner(line.substr(0, line.find(';')));
  skip_line_number(scanner);
  if (!letters::same(keyword(scanner), "LBL") || scanner.at_end()) {
    return {};
  }
  std::string label = parts().labels.read(scanner);
  return label == "0" ? std::string() : label;
}

}  // namespace feedscope::heidenhain
