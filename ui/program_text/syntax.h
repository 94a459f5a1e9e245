#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/program/dialect.h"
#include "core/program/text/lexer.h"

namespace feedscope::ui {

/// Kind of a piece of program text, for colours.
enum class TokenKind : std::uint8_t {
  text,  ///< numbers, operators, everything else
  comment,
  label,         ///< block and program numbers, jump labels, start and end of tapes
  block_delete,  ///< "/" with its level
  g_code,
  m_code,
  axis_x,
  axis_y,
  axis_z,
  other_axis,
  argument,  ///< centres, radii, parameters
  feed,      ///< F and S with their values
  tool,
  keyword,
  variable,
  literal,  ///< quoted text
};
inline constexpr std::size_t token_kind_count = 16;

struct Token {
  std::uint32_t from = 0;  ///< byte in the line
  std::uint32_t length = 0;
  TokenKind kind = TokenKind::text;

  bool operator==(const Token&) const = default;
};

/// Splits one line of a program for colours, by the dialect's rules for words, comments and names. It
/// considers no other line and checks nothing: that is the reader's task.
class Syntax {
 public:
  explicit Syntax(Dialect dialect = Dialect::iso) : dialect_(dialect) {}

  /// Pieces in order; text between them is TokenKind::text. Valid until the next call.
  const std::vector<Token>& tokens_of(std::string_view line);

 private:
  enum class Family { iso, sinumerik, heidenhain };

  Family family() const;
  bool brackets_are_comments() const;
  std::size_t read(std::size_t at);
  std::size_t read_sign(std::size_t at);
  std::size_t read_letter(std::size_t at);
  std::size_t read_iso_name(std::size_t at);
  std::size_t read_sinumerik_name(std::size_t at);
  std::size_t read_heidenhain_start();
  std::size_t read_heidenhain_name(std::size_t at);
  std::size_t read_word(std::size_t at, std::size_t letters);
  std::size_t read_comment(std::size_t at);
  std::size_t read_number_sign(std::size_t at);
  std::size_t digits_end(std::size_t at) const;
  std::size_t value_end(std::size_t at) const;
  std::size_t add(std::size_t from, std::size_t to, TokenKind kind);
  std::size_t skip_blanks(std::size_t at) const;
  char peek(std::size_t at) const { return at < line_.size() ? line_[at] : '\0'; }
  bool at_start(std::size_t at) const;

  Dialect dialect_;
  std::string_view line_;
  std::vector<Token> tokens_;
  CommentEnds comment_ends_;
};

}  // namespace feedscope::ui
