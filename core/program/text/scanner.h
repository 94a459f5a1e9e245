#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace feedscope {

/// Characters of NC texts: ASCII whatever the locale.
namespace letters {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr char to_upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr bool is_letter(char c) {
  return to_upper(c) >= 'A' && to_upper(c) <= 'Z';
}
/// True for characters of a name after its first one.
constexpr bool is_name_part(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}
/// Upper and lower case are the same.
bool same(std::string_view a, std::string_view b);

}  // namespace letters

/// A place in a line that moves on as statements are read, for syntax beyond letters with numbers. Skips
/// blanks before the text it looks for; upper and lower case are the same.
class Scanner {
 public:
  explicit Scanner(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

  std::string_view text() const { return text_; }
  std::size_t at() const { return at_; }
  void move_to(std::size_t at) { at_ = at; }
  /// 1-based byte column of the next character that is not blank; at the end of the last character.
  std::uint32_t column();
  bool at_end();
  /// The next character that is not blank; 0 at the end.
  char peek();
  /// The character `ahead` places after the next one, blanks counted; 0 beyond the end.
  char peek_at(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  std::string_view rest();

  /// Reads the given text and returns true, or stays.
  bool take(char c);
  bool take(std::string_view symbol);
  /// The same for a name that no name character follows.
  bool take_name(std::string_view name);
  /// The same for a name that a digit may follow, "DO1".
  bool take_keyword(std::string_view name);
  /// Reads letters, digits and underscores that begin with a letter or underscore; empty if none is next.
  std::string_view name();
  /// Skips all digits that follow.
  void skip_digits();

  /// Reads an unsigned decimal number, with a point or, if `comma`, a comma; none if none is next. Throws
  /// ReadFault "malformed-number" and "number-range".
  std::optional<double> number(bool comma = false);

 private:
  void skip_blanks();

  std::string_view text_;
  std::size_t at_;
};

}  // namespace feedscope
