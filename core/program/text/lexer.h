#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace feedscope {

/// An address letter with its number, "X-12.5".
struct Word {
  char letter = ' ';         ///< upper case
  bool has_point = false;    ///< the number was written with a decimal point
  std::uint32_t column = 0;  ///< 1-based byte column of the letter
  std::uint32_t length = 0;  ///< bytes from the letter to the number's end
  double value = 0;
  bool comma = false;  ///< a comma precedes the letter, ",R2"
};

/// Faults that the lexer finds.
enum class FaultKind : std::uint8_t {
  malformed_number,  ///< "X1..2", "X-", "Xnan", "X1e5"
  number_range,      ///< beyond +-1e9
  unclosed_comment,  ///< "(" without ")"; the rest of the line counts as the comment
  character,         ///< a character that starts no word; the rest of the line is not read
};

struct Fault {
  FaultKind kind = FaultKind::character;
  std::uint32_t column = 0;  ///< 1-based byte column
  std::uint32_t length = 0;  ///< bytes
};

/// One line split into words.
struct Block {
  std::string_view text;      ///< the line
  std::vector<Word> words;    ///< in written order
  std::vector<Fault> faults;  ///< in written order; empty for a sound line
  int delete_level = 0;       ///< of a leading "/": 1 to 9, "/" and "/0" are 1; 0: none
  std::uint32_t percent = 0;  ///< column of "%", which ends the line; 0: none
  /// Column from which the line has more than words with plain numbers: a name, variable, expression or
  /// assignment, together with the letter before it; 0: none. The dialect reads it.
  std::uint32_t statement = 0;

  std::string_view text_of(const Word& word) const { return text.substr(word.column - 1, word.length); }
  std::string_view text_of(const Fault& fault) const { return text.substr(fault.column - 1, fault.length); }
};

/// Finds the ends of the comments "(...)" of one line, from left to right. Comments may be nested until one
/// of them is not closed.
class CommentEnds {
 public:
  /// One past the bracket that closes the comment at `at`; none if there is no such bracket.
  std::optional<std::size_t> find(std::string_view text, std::size_t at);

 private:
  bool nest_ = true;  ///< false once the line has an unmatched "("
};

/// Meaning of a bracket in a dialect.
enum class Brackets : std::uint8_t {
  comment,    ///< "(...)" is a comment and may be nested
  statement,  ///< it belongs to a statement, like every other character that starts no word
};

/// Splits the lines of address-letter dialects, whatever the meaning of the words.
///
/// Upper and lower case are the same. Blanks may occur between words, after the letter and after the sign,
/// or nowhere. ";" starts a comment. Numbers are decimal with a point, whatever the locale. ":100" at the
/// start of a line is O100, as on tapes.
class Lexer {
 public:
  explicit Lexer(Brackets brackets = Brackets::comment) : brackets_(brackets) {}

  /// Makes "K1.E5." two words, as in the arguments of a macro; otherwise the E would start an exponent, which
  /// no word has.
  void take_e_as_word() { e_is_word_ = true; }

  /// The block is valid until the next call; its storage is used again.
  const Block& read(std::string_view line);

 private:
  std::size_t read_word(std::size_t at);
  std::size_t read_comment(std::size_t at);
  std::size_t read_delete(std::size_t at);
  std::size_t stop_at(std::size_t at);
  bool starts_statement(char c) const;
  std::size_t add_fault(FaultKind kind, std::size_t from, std::size_t to);

  Block block_;
  CommentEnds comment_ends_;
  Brackets brackets_;
  bool e_is_word_ = false;
};

}  // namespace feedscope
