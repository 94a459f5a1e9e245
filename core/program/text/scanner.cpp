#include "core/program/text/scanner.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

/// Characters of a number whose digits and power of ten are exact as double: their quotient is rounded once.
constexpr std::size_t exact_length = 15;
constexpr auto powers_of_ten = std::to_array<double>(
    {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15});

double long_number(std::string_view text) {
  const char point = text.find(',') == std::string_view::npos ? '.' : ',';
  double value = std::numeric_limits<double>::infinity();
  fast_float::from_chars_advanced(text.data(), text.data() + text.size(), value,
                                  fast_float::parse_options{fast_float::chars_format::fixed, point});
  return value;
}

}  // namespace

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
  const auto is_point = [comma](char c) { return c == '.' || (comma && c == ','); };
  if (!letters::is_digit(first) && !(is_point(first) && letters::is_digit(peek_at(1)))) {
    return std::nullopt;
  }
  const std::size_t from = at_;
  std::uint64_t digits = 0;
  const auto take_digits = [&] {
    for (; at_ < text_.size() && letters::is_digit(text_[at_]); ++at_) {
      digits = digits * 10 + static_cast<std::uint64_t>(text_[at_] - '0');
    }
    return at_;
  };
  const std::size_t whole_end = take_digits();
  std::size_t decimals = 0;
  if (at_ < text_.size() && is_point(text_[at_])) {
    ++at_;
    decimals = take_digits() - whole_end - 1;
  }
  const double value = at_ - from <= exact_length ? static_cast<double>(digits) / powers_of_ten[decimals]
                                                  : long_number(text_.substr(from, at_ - from));
  if (at_ < text_.size() && text_[at_] == '.') {
    throw ReadFault{
        "malformed-number", static_cast<std::uint32_t>(from + 1),
        message(NC_("core", "{} has no valid number"), in_quotes(text_.substr(from, at_ - from + 1))),
        NC_("core", "correct the number")};
  }
  if (!(value <= number_limit)) {
    throw ReadFault{"number-range", static_cast<std::uint32_t>(from + 1),
                    message(NC_("core", "{} is above the largest number, 1000000000"),
                            in_quotes(text_.substr(from, at_ - from))),
                    NC_("core", "write a smaller number")};
  }
  return value;
}

}  // namespace feedscope
