// The part of IsoReader that reads lines with variables, expressions and names.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/program/iso/iso_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

constexpr double value_limit = 1e9;
constexpr std::string_view axis_words = "ABCIJKRUVWXYZ";

/// A name of two letters and more that is no function: "CYCLE832", "SETVN"; empty for a word such as "X#1".
std::string_view foreign_name(Scanner scan) {
  const std::string_view name = scan.name();
  const bool is_name = name.size() > 1 && !letters::is_digit(name[1]) && scan.peek() != '[';
  return is_name ? name : std::string_view();
}

/// "M117 Layer 3": what follows is for the operator of a printer.
bool ends_in_text(const Block& block) {
  return !block.words.empty() && block.words.back().letter == 'M' &&
         (block.words.back().value == 117 || block.words.back().value == 118);
}

}  // namespace

bool IsoReader::run_statement(const Block& block) {
  expression_.set_rounding_step(1);
  Scanner scan(without_comments(block), block.statement - 1);
  statement_.words.clear();
  statement_.faults.clear();
  if (run_flow(block, scan)) {
    words_met_ = true;
    return false;
  }
  statement_.words = block.words;
  statement_.faults = block.faults;
  if (ends_in_text(block)) {
    run_block(block, true);
    return false;
  }
  run_items(scan);
  return scan.peek() == '%';
}

void IsoReader::run_items(Scanner& scan) {
  statement_.text = text().line(line());
  assignments_.clear();
  run_block(statement_, read_items(scan));
}

std::string_view IsoReader::without_comments(const Block& block) {
  statement_text_ = block.text;
  CommentEnds ends;
  for (std::size_t at = 0; at < statement_text_.size(); ++at) {
    if (statement_text_[at] == ';') {
      statement_text_.resize(at);
    } else if (statement_text_[at] == '(') {
      const std::optional<std::size_t> end = ends.find(block.text, at);
      if (!end) {
        report(Severity::error, "unclosed-comment", 0, static_cast<std::uint32_t>(at + 1), [&] {
          return Text{fmt::format("the comment {} is not closed", quoted(block.text.substr(at))),
                      "the rest of the line is taken for the comment; add the closing bracket"};
        });
      }
      const std::size_t stop = end.value_or(block.text.size());
      std::fill(statement_text_.begin() + static_cast<std::ptrdiff_t>(at),
                statement_text_.begin() + static_cast<std::ptrdiff_t>(stop), ' ');
      at = stop - 1;
    }
  }
  statement_text_.resize(statement_text_.find_last_not_of(" \t") + 1);
  return statement_text_;
}

void IsoReader::report_fault(const ReadFault& fault) {
  report(Severity::error, fault.code, 0, fault.column, [&] { return Text{fault.message, fault.hint}; });
}

bool IsoReader::read_items(Scanner& scan) {
  try {
    while (!scan.at_end() && scan.peek() != '%') {
      if (scan.peek() == '#') {
        read_assignment(scan);
      } else {
        read_word(scan);
      }
    }
    for (const Assignment& assignment : assignments_) {
      assign(assignment);
    }
    return true;
  } catch (const ReadFault& fault) {
    report_fault(fault);
    leave_line(scan);
    return false;
  }
}

void IsoReader::read_word(Scanner& scan) {
  const std::uint32_t column = scan.column();
  const bool comma =
      !follows_linuxcnc(dialect_) && scan.peek() == ',' &&
      std::string_view("RC").find(letters::to_upper(scan.peek_at(1))) != std::string_view::npos;
  if (comma) {
    scan.take(',');
  }
  const char letter = letters::to_upper(scan.peek());
  const bool polar = (letter == '@' || letter == '^') && follows_linuxcnc(dialect_);
  if (!letters::is_letter(letter) && !polar) {
    throw ReadFault{"unknown-character", column,
                    fmt::format("{} does not start a word", quoted({&letter, 1})),
                    "the rest of the line is not read and the block does not move; remove the character"};
  }
  if (const std::string_view name = foreign_name(scan); !name.empty()) {
    throw ReadFault{
        "unread-statement", column,
        fmt::format("{} is not a word of ISO programs", quoted(statement_.text.substr(column - 1))),
        "the block does not move; if the program is another dialect's, name it with --dialect"};
  }
  scan.take(letter);
  expression_.set_rounding_step(axis_words.find(letter) == std::string_view::npos ? 1
                                : state_.inch                                     ? 1e-4
                                                                                  : 1e-3);
  Word word;
  word.letter = letter;
  word.comma = comma;
  word.column = column;
  word.value = read_value(scan, word.has_point);
  word.length = static_cast<std::uint32_t>(scan.at() + 1 - column);
  expression_.set_rounding_step(1);
  if (is_null(word.value)) {
    return;
  }
  if (!(std::abs(word.value) <= value_limit)) {
    throw ReadFault{"number-range", column,
                    fmt::format("{}{} is beyond the largest number, 1000000000", letter, word.value),
                    "the block does not move; check the values that go into it"};
  }
  statement_.words.push_back(word);
}

double IsoReader::read_value(Scanner& scan, bool& has_point) {
  const bool negative = scan.take('-');
  if (!negative) {
    scan.take('+');
  }
  scan.peek();
  const std::size_t from = scan.at();
  const std::optional<double> number = scan.number();
  const double value = number ? *number : expression_.read_operand(scan);
  has_point = number ? scan.text().substr(from, scan.at() - from).find('.') != std::string_view::npos
                     : value != std::floor(value);
  return negative ? -value : value;
}

void IsoReader::read_assignment(Scanner& scan) {
  Assignment assignment;
  assignment.column = scan.column();
  scan.take('#');
  assignment.name = expression_.variable_name(scan);
  if (assignment.name.empty()) {
    assignment.number = expression_.variable_number(scan);
  }
  const std::uint32_t column = scan.column();
  if (!scan.take('=')) {
    throw ReadFault{"expression", column, "\"=\" is missing after the variable",
                    "write the value that it is given"};
  }
  assignment.value = expression_.read(scan);
  if (follows_linuxcnc(dialect_)) {
    // The words and values of a block see the variables as they were before it.
    assignments_.push_back(std::move(assignment));
  } else {
    assign(assignment);
  }
}

void IsoReader::assign(const Assignment& assignment) {
  constexpr std::uint32_t alarm = 3000;
  words_met_ = true;
  if (!assignment.name.empty()) {
    variables_.set(assignment.name, assignment.value);
  } else if (!follows_linuxcnc(dialect_) && assignment.number == alarm) {
    raise_alarm(assignment.value, assignment.column);
  } else if (const auto offset = offset_variable(assignment.number); offset && !follows_linuxcnc(dialect_)) {
    set_offset_variable(*offset, assignment.value);
  } else if (assignment.number == 0 || offset || built_in(assignment.number)) {
    throw ReadFault{"variable", assignment.column,
                    fmt::format("#{} cannot be given a value", assignment.number),
                    "it is left out; use another variable"};
  } else {
    variables_.set(assignment.number, assignment.value);
  }
}

}  // namespace feedscope
