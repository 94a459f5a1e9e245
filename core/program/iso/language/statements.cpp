#include "core/program/iso/language/statements.h"

#include <algorithm>
#include <cmath>

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::iso {

namespace {

constexpr double value_limit = 1e9;
constexpr std::string_view axis_words = "ABCIJKRUVWXYZ";

/// A name of two or more letters that is not a function: "CYCLE832", "SETVN"; empty for a word such as "X#1".
std::string_view foreign_name(Scanner scan) {
  const std::string_view name = scan.name();
  const bool is_name = name.size() > 1 && !letters::is_digit(name[1]) && scan.peek() != '[';
  return is_name ? name : std::string_view();
}

}  // namespace

Scanner Statements::begin(const Block& line) {
  expression_.set_rounding_step(1);
  block_.words.clear();
  block_.faults.clear();
  return Scanner(without_comments(line), line.statement - 1);
}

void Statements::keep_words(const Block& line) {
  block_.words = line.words;
  block_.faults = line.faults;
}

std::string_view Statements::without_comments(const Block& line) {
  text_ = line.text;
  CommentEnds ends;
  for (std::size_t at = 0; at < text_.size(); ++at) {
    if (text_[at] == ';') {
      text_.resize(at);
    } else if (text_[at] == '(') {
      const std::optional<std::size_t> end = ends.find(line.text, at);
      if (!end) {
        report(Severity::error, "unclosed-comment", 0, static_cast<std::uint32_t>(at + 1), [&] {
          return Text{message(NC_("core", "the comment {} is not closed"), in_quotes(line.text.substr(at))),
                      NC_("core", "the rest of the line is used as the comment; add the closing bracket")};
        });
      }
      const std::size_t stop = end.value_or(line.text.size());
      std::fill(text_.begin() + static_cast<std::ptrdiff_t>(at),
                text_.begin() + static_cast<std::ptrdiff_t>(stop), ' ');
      at = stop - 1;
    }
  }
  text_.resize(text_.find_last_not_of(" \t") + 1);
  return text_;
}

bool Statements::read(Scanner& scan) {
  block_.text = lines().text().line(lines().line());
  assignments_.clear();
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
    machining_.report(fault);
    skip_rest(scan);
    return false;
  }
}

void Statements::read_word(Scanner& scan) {
  const std::uint32_t column = scan.column();
  const bool comma =
      !is_linuxcnc() && scan.peek() == ',' &&
      std::string_view("RC").find(letters::to_upper(scan.peek_at(1))) != std::string_view::npos;
  if (comma) {
    scan.take(',');
  }
  const char letter = letters::to_upper(scan.peek());
  const bool polar = (letter == '@' || letter == '^') && is_linuxcnc();
  if (!letters::is_letter(letter) && !polar) {
    throw ReadFault{
        "unknown-character", column,
        message(NC_("core", "{} does not start a word"), in_quotes({&letter, 1})),
        NC_("core", "the rest of the line is skipped and the block does not move; remove the character")};
  }
  if (const std::string_view name = foreign_name(scan); !name.empty()) {
    throw ReadFault{
        "unread-statement", column,
        message(NC_("core", "{} is not a word of ISO programs"), in_quotes(block_.text.substr(column - 1))),
        NC_("core", "the block does not move; if the program has another dialect, give it with --dialect")};
  }
  scan.take(letter);
  expression_.set_rounding_step(axis_words.find(letter) == std::string_view::npos ? 1
                                : modal_.inch                                     ? 1e-4
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
                    message(NC_("core", "{}{} is above the largest number, 1000000000"), letter, word.value),
                    NC_("core", "the block does not move; check the values that go into it")};
  }
  block_.words.push_back(word);
}

double Statements::read_value(Scanner& scan, bool& has_point) {
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

void Statements::read_assignment(Scanner& scan) {
  Assignment assignment;
  assignment.column = scan.column();
  scan.take('#');
  assignment.name = expression_.variable_name(scan);
  if (assignment.name.empty()) {
    assignment.number = expression_.variable_number(scan);
  }
  const std::uint32_t column = scan.column();
  if (!scan.take('=')) {
    throw ReadFault{"expression", column, NC_("core", "\"=\" is missing after the variable"),
                    NC_("core", "write its value")};
  }
  assignment.value = expression_.read(scan);
  if (is_linuxcnc()) {
    // The words and values of a block see the variables as they were before it.
    assignments_.push_back(std::move(assignment));
  } else {
    assign(assignment);
  }
}

void Statements::assign(const Assignment& assignment) {
  has_assigned_ = true;
  if (assignment.name.empty()) {
    system_.set(assignment.number, assignment.value, assignment.column);
  } else {
    variables_.set(assignment.name, assignment.value);
  }
}

}  // namespace feedscope::iso
