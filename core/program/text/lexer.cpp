#include "core/program/text/lexer.h"

#include <fast_float/fast_float.h>

#include <algorithm>

#include "core/program/text/scanner.h"

namespace feedscope {

namespace {

constexpr double number_limit = 1e9;

using letters::is_blank;
using letters::is_digit;
using letters::is_letter;
using letters::to_upper;

bool is_number_part(char c) {
  return is_digit(c) || c == '.' || c == '+' || c == '-';
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank(text[at])) {
    ++at;
  }
  return at;
}

/// End of a name such as "CYCLE832", "_X" or "BEGIN".
std::size_t name_end(std::string_view text, std::size_t at) {
  while (at < text.size() && letters::is_name_part(text[at])) {
    ++at;
  }
  return at;
}

/// End of a malformed number: up to a blank, a comment or a letter that starts the next word.
std::size_t bad_number_end(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    const bool exponent = to_upper(text[at]) == 'E' && at + 1 < text.size() && is_number_part(text[at + 1]);
    if (!is_number_part(text[at]) && !exponent) {
      break;
    }
    ++at;
  }
  return at;
}

/// "SQRT[" or "SQRT [", a function's name with its bracket.
bool starts_function(std::string_view text, std::size_t at) {
  const std::size_t end = name_end(text, at);
  const std::size_t next = skip_blanks(text, end);
  return end - at > 1 && is_letter(text[at + 1]) && next < text.size() && text[next] == '[';
}

bool is_not_finite(std::string_view name) {
  return letters::same(name, "NAN") || letters::same(name, "INF") || letters::same(name, "INFINITY");
}

}  // namespace

std::optional<std::size_t> CommentEnds::find(std::string_view text, std::size_t at) {
  int depth = 0;
  for (std::size_t i = at; nest_ && i < text.size(); ++i) {
    if (text[i] == '(') {
      ++depth;
    } else if (text[i] == ')' && --depth == 0) {
      return i + 1;
    }
  }
  nest_ = false;
  const std::size_t first_close = text.find(')', at);
  return first_close == std::string_view::npos ? std::nullopt : std::optional(first_close + 1);
}

bool Lexer::starts_statement(char c) const {
  return c == '#' || c == '[' || c == ']' || c == '<' || c == '>' || c == '=' || c == '"' || c == '_' ||
         (brackets_ == Brackets::statement && (c == '(' || c == ':'));
}

std::size_t Lexer::add_fault(FaultKind kind, std::size_t from, std::size_t to) {
  block_.faults.push_back(
      {kind, static_cast<std::uint32_t>(from + 1), static_cast<std::uint32_t>(to - from)});
  return to;
}

std::size_t Lexer::stop_at(std::size_t at) {
  block_.statement = static_cast<std::uint32_t>(at + 1);
  return block_.text.size();
}

std::size_t Lexer::read_comment(std::size_t at) {
  const std::optional<std::size_t> end = comment_ends_.find(block_.text, at);
  return end ? *end : add_fault(FaultKind::unclosed_comment, at, block_.text.size());
}

std::size_t Lexer::read_delete(std::size_t at) {
  const std::string_view text = block_.text;
  block_.delete_level = 1;
  if (at + 1 < text.size() && is_digit(text[at + 1])) {
    block_.delete_level = std::max(1, text[at + 1] - '0');
    return at + 2;
  }
  return at + 1;
}

std::size_t Lexer::read_word(std::size_t at) {
  const std::string_view text = block_.text;
  const char* const end = text.data() + text.size();
  std::size_t i = skip_blanks(text, at + 1);
  bool negative = false;
  const bool has_sign = i < text.size() && (text[i] == '-' || text[i] == '+');
  if (has_sign) {
    negative = text[i] == '-';
    i = skip_blanks(text, i + 1);
  }
  if (i == at + 1 && i < text.size() && (is_letter(text[i]) || text[i] == '_')) {
    const std::size_t stop = name_end(text, at);
    if (is_not_finite(text.substr(i, stop - i))) {
      return add_fault(FaultKind::malformed_number, at, stop);
    }
    return stop_at(at);
  }
  if (i > at + 1 && i < text.size() && is_letter(text[i]) && starts_function(text, i)) {
    return stop_at(at);
  }
  if (has_sign && i + 1 < text.size() && is_letter(text[i]) && is_letter(text[i + 1]) &&
      !is_not_finite(text.substr(i, name_end(text, i) - i))) {
    return stop_at(at);
  }
  if (i < text.size() && starts_statement(text[i])) {
    return stop_at(at);
  }
  if (i == text.size() || !(is_digit(text[i]) || text[i] == '.')) {
    if (brackets_ == Brackets::statement) {
      return stop_at(at);
    }
    const std::size_t first = skip_blanks(text, at + 1);
    const bool letter_alone = first == text.size() || !is_number_part(text[first]);
    return add_fault(FaultKind::malformed_number, at, letter_alone ? at + 1 : bad_number_end(text, first));
  }
  double value = 0;
  const auto [stop, status] =
      fast_float::from_chars(text.data() + i, end, value, fast_float::chars_format::fixed);
  const std::size_t number_end =
      status == std::errc::invalid_argument ? i : static_cast<std::size_t>(stop - text.data());
  const std::size_t next = skip_blanks(text, number_end);
  const bool exponent = !e_is_word_ && number_end < text.size() && to_upper(text[number_end]) == 'E' &&
                        number_end + 1 < text.size() && is_number_part(text[number_end + 1]);
  if (number_end == i || exponent || (next < text.size() && is_number_part(text[next]))) {
    return add_fault(FaultKind::malformed_number, at, bad_number_end(text, next));
  }
  if (!(value <= number_limit)) {
    return add_fault(FaultKind::number_range, at, number_end);
  }
  const bool scaled = brackets_ == Brackets::statement && number_end + 1 < text.size() &&
                      to_upper(text[number_end]) == 'E' && to_upper(text[number_end + 1]) == 'X';
  if (scaled || (next < text.size() && starts_statement(text[next]))) {
    return stop_at(at);
  }
  const bool has_point = text.substr(i, number_end - i).find('.') != std::string_view::npos;
  const char letter = text[at] == ':' ? 'O' : to_upper(text[at]);
  block_.words.push_back({letter, has_point, static_cast<std::uint32_t>(at + 1),
                          static_cast<std::uint32_t>(number_end - at), negative ? -value : value});
  return number_end;
}

const Block& Lexer::read(std::string_view line) {
  block_.text = line;
  block_.words.clear();
  block_.faults.clear();
  block_.delete_level = 0;
  block_.percent = 0;
  block_.statement = 0;
  comment_ends_ = {};
  std::size_t at = 0;
  while ((at = skip_blanks(line, at)) < line.size()) {
    const char c = line[at];
    const bool is_program_number = c == ':' && brackets_ == Brackets::comment && block_.words.empty() &&
                                   at + 1 < line.size() && is_digit(line[at + 1]);
    if (is_letter(c) || is_program_number) {
      at = read_word(at);
    } else if (c == '(' && brackets_ == Brackets::comment) {
      at = read_comment(at);
    } else if (c == ';') {
      break;
    } else if (c == '%') {
      block_.percent = static_cast<std::uint32_t>(at + 1);
      break;
    } else if (c == '/' && block_.delete_level == 0 &&
               (block_.words.empty() || (block_.words.size() == 1 && block_.words[0].letter == 'N'))) {
      at = read_delete(at);
    } else if (starts_statement(c) || c == '@' || c == '^' || c == ',' || brackets_ == Brackets::statement) {
      at = stop_at(at);
    } else {
      add_fault(FaultKind::character, at, at + 1);
      break;
    }
  }
  return block_;
}

}  // namespace feedscope
