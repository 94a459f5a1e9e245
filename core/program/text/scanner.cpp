#include "core/program/text/scanner.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

bool letters::same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return to_upper(x) == to_upper(y); });
}

void Scanner::skip_blanks() {
  while (at_ < text_.size() && letters::is_blank(text_[at_])) {
    ++at_;
  }
}

std::uint32_t Scanner::column() {
  skip_blanks();
  return static_cast<std::uint32_t>(std::min(at_ + 1, text_.size()));
}

bool Scanner::at_end() {
  skip_blanks();
  return at_ >= text_.size();
}

char Scanner::peek() {
  return at_end() ? '\0' : text_[at_];
}

std::string_view Scanner::rest() {
  skip_blanks();
  return text_.substr(at_);
}

bool Scanner::take(char c) {
  if (letters::to_upper(peek()) != letters::to_upper(c)) {
    return false;
  }
  ++at_;
  return true;
}

bool Scanner::take(std::string_view symbol) {
  skip_blanks();
  if (!letters::same(text_.substr(at_, symbol.size()), symbol)) {
    return false;
  }
  at_ += symbol.size();
  return true;
}

bool Scanner::take_name(std::string_view name) {
  skip_blanks();
  const char after = peek_at(name.size());
  return !letters::is_name_part(after) && take(name);
}

bool Scanner::take_keyword(std::string_view name) {
  skip_blanks();
  const char after = peek_at(name.size());
  return !letters::is_letter(after) && after != '_' && take(name);
}

std::string_view Scanner::name() {
  const char first = peek();
  if (!letters::is_letter(first) && first != '_') {
    return {};
  }
  const std::size_t from = at_;
  while (at_ < text_.size() && letters::is_name_part(text_[at_])) {
    ++at_;
  }
  return text_.substr(from, at_ - from);
}

void Scanner::skip_digits() {
  skip_blanks();
  while (at_ < text_.size() && letters::is_digit(text_[at_])) {
    ++at_;
  }
}

std::optional<double> Scanner::number(bool comma) {
  constexpr double number_limit = 1e9;
  const char first = peek();
  const bool is_point = first == '.' || (comma && first == ',');
  if (!letters::is_digit(first) && !(is_point && letters::is_digit(peek_at(1)))) {
    return std::nullopt;
  }
  const std::size_t from = at_;
  const char* const end = text_.data() + text_.size();
  const char point =
      comma && text_.substr(at_, text_.find_first_not_of("0123456789", at_) - at_ + 1).ends_with(',') ? ','
                                                                                                      : '.';
  double value = 0;
  const auto [stop, status] = fast_float::from_chars_advanced(
      text_.data() + at_, end, value, fast_float::parse_options{fast_float::chars_format::fixed, point});
  at_ = static_cast<std::size_t>(stop - text_.data());
  if (status == std::errc::invalid_argument || (at_ < text_.size() && text_[at_] == '.')) {
    throw ReadFault{"malformed-number", static_cast<std::uint32_t>(from + 1),
                    fmt::format("{} has no readable number", quoted(text_.substr(from, at_ - from + 1))),
                    "correct the number"};
  }
  if (!(value <= number_limit)) {
    throw ReadFault{
        "number-range", static_cast<std::uint32_t>(from + 1),
        fmt::format("{} is beyond the largest number, 1000000000", quoted(text_.substr(from, at_ - from))),
        "write a smaller number"};
  }
  return value;
}

}  // namespace feedscope
