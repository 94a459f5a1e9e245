#include "ui/program_text/syntax.h"

#include <algorithm>

#include "core/program/text/scanner.h"

namespace feedscope::ui {

namespace {

using letters::is_blank;
using letters::is_digit;
using letters::is_letter;
using letters::is_name_part;
using letters::to_upper;

TokenKind kind_of_letter(char letter) {
  switch (to_upper(letter)) {
    case 'G':
      return TokenKind::g_code;
    case 'M':
      return TokenKind::m_code;
    case 'X':
      return TokenKind::axis_x;
    case 'Y':
      return TokenKind::axis_y;
    case 'Z':
      return TokenKind::axis_z;
    case 'A':
    case 'B':
    case 'C':
    case 'U':
    case 'V':
    case 'W':
      return TokenKind::other_axis;
    case 'F':
    case 'S':
      return TokenKind::feed;
    case 'T':
    case 'D':
    case 'H':
      return TokenKind::tool;
    case 'N':
    case 'O':
      return TokenKind::label;
    default:
      return TokenKind::argument;
  }
}

/// For axes and arguments only the letter is coloured, which keeps their numbers easy to read.
bool takes_its_value(TokenKind kind) {
  switch (kind) {
    case TokenKind::g_code:
    case TokenKind::m_code:
    case TokenKind::feed:
    case TokenKind::tool:
    case TokenKind::label:
      return true;
    default:
      return false;
  }
}

bool is_axis(char letter) {
  const TokenKind kind = kind_of_letter(letter);
  return kind == TokenKind::axis_x || kind == TokenKind::axis_y || kind == TokenKind::axis_z ||
         kind == TokenKind::other_axis;
}

bool is_number_part(char c) {
  return is_digit(c) || c == '.' || c == '+' || c == '-';
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view other) { return letters::same(word, other); });
}

}  // namespace

const std::vector<Token>& Syntax::tokens_of(std::string_view line) {
  line_ = line;
  tokens_.clear();
  comment_ends_ = {};
  std::size_t at = family() == Family::heidenhain ? read_heidenhain_start() : 0;
  while (at < line_.size()) {
    at = read(at);
  }
  return tokens_;
}

/// Reads a block number, or a whole structure line, "12 * - ROUGHING".
std::size_t Syntax::read_heidenhain_start() {
  const std::size_t start = skip_blanks(0);
  const std::size_t end = add(start, digits_end(start), TokenKind::label);
  const std::size_t next = skip_blanks(end);
  return peek(next) == '*' ? add(next, line_.size(), TokenKind::comment) : end;
}

Syntax::Family Syntax::family() const {
  switch (dialect_) {
    case Dialect::sinumerik:
      return Family::sinumerik;
    case Dialect::heidenhain:
      return Family::heidenhain;
    default:
      return Family::iso;
  }
}

bool Syntax::brackets_are_comments() const {
  return family() == Family::iso && dialect_ != Dialect::heidenhain_iso;
}

std::size_t Syntax::skip_blanks(std::size_t at) const {
  while (is_blank(peek(at))) {
    ++at;
  }
  return at;
}

std::size_t Syntax::add(std::size_t from, std::size_t to, TokenKind kind) {
  if (to > from) {
    tokens_.push_back({static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to - from), kind});
  }
  return to;
}

/// Whether only a block number or nothing precedes.
bool Syntax::at_start(std::size_t at) const {
  return std::ranges::all_of(tokens_, [](const Token& t) { return t.kind == TokenKind::label; }) &&
         (tokens_.empty() || skip_blanks(tokens_.back().from + tokens_.back().length) == at);
}

std::size_t Syntax::read(std::size_t at) {
  const char c = line_[at];
  if (is_letter(c) || (c == '_' && family() != Family::iso)) {
    return read_letter(at);
  }
  if (is_number_part(c)) {
    return value_end(at);
  }
  return is_blank(c) ? skip_blanks(at) : read_sign(at);
}

std::size_t Syntax::read_sign(std::size_t at) {
  switch (line_[at]) {
    case ';':
      return add(at, line_.size(), TokenKind::comment);
    case '(':
      return brackets_are_comments() ? read_comment(at) : at + 1;
    case '%':
      return family() == Family::heidenhain ? at + 1 : add(at, line_.size(), TokenKind::label);
    case '/':
      return at_start(at) ? add(at, is_digit(peek(at + 1)) ? at + 2 : at + 1, TokenKind::block_delete)
                          : at + 1;
    case '#':
      return read_number_sign(at);
    case '"': {
      const std::size_t end = line_.find('"', at + 1);
      return add(at, end == std::string_view::npos ? line_.size() : end + 1, TokenKind::literal);
    }
    case '$': {
      std::size_t end = at + 1;
      while (is_name_part(peek(end)) || peek(end) == '$') {
        ++end;
      }
      return add(at, end, TokenKind::variable);
    }
    default:
      return at + 1;
  }
}

std::size_t Syntax::read_comment(std::size_t at) {
  return add(at, comment_ends_.find(line_, at).value_or(line_.size()), TokenKind::comment);
}

/// "#12", "#<name>", or "#" before an expression.
std::size_t Syntax::read_number_sign(std::size_t at) {
  std::size_t end = at + 1;
  if (peek(end) == '<') {
    end = std::min(line_.find('>', end), line_.size() - 1) + 1;
  }
  return add(at, digits_end(end), TokenKind::variable);
}

std::size_t Syntax::digits_end(std::size_t at) const {
  while (is_digit(peek(at))) {
    ++at;
  }
  return at;
}

/// End of a number at `at`, including its sign.
std::size_t Syntax::value_end(std::size_t at) const {
  while (is_number_part(peek(at)) ||
         (peek(at) == ',' && family() == Family::heidenhain && is_digit(peek(at + 1)))) {
    ++at;
  }
  return at;
}

std::size_t Syntax::read_letter(std::size_t at) {
  switch (family()) {
    case Family::sinumerik:
      return read_sinumerik_name(at);
    case Family::heidenhain:
      return read_heidenhain_name(at);
    case Family::iso:
      break;
  }
  return read_iso_name(at);
}

/// A word whose address is the first `letters` characters.
std::size_t Syntax::read_word(std::size_t at, std::size_t letters) {
  const TokenKind kind = kind_of_letter(line_[at + letters - 1]);
  const std::size_t address = at + letters;
  const std::size_t value = skip_blanks(address);
  const bool has_value = is_number_part(peek(value));
  const std::size_t end = has_value ? value_end(value) : address;
  add(at, takes_its_value(kind) ? end : address, kind);
  return end;
}

std::size_t Syntax::read_iso_name(std::size_t at) {
  std::size_t end = at;
  while (is_letter(peek(end))) {
    ++end;
  }
  const std::string_view name = line_.substr(at, end - at);
  if (dialect_ == Dialect::heidenhain_iso && to_upper(name[0]) == 'Q') {
    return add(at, digits_end(end), TokenKind::variable);
  }
  if (to_upper(line_[at]) == 'O' && name.size() == 1 && peek(skip_blanks(end)) == '<') {
    return add(at, std::min(line_.find('>', end), line_.size() - 1) + 1, TokenKind::label);
  }
  // "IX" and similar are incremental axes. The last letter of a longer name may belong to a number,
  // which only the reader can decide, and reports if it cannot.
  if (name.size() == 1 || (name.size() == 2 && to_upper(name[0]) == 'I' && is_axis(name[1]))) {
    return read_word(at, name.size());
  }
  return add(at, end, TokenKind::keyword);
}

std::size_t Syntax::read_sinumerik_name(std::size_t at) {
  std::size_t end = at + 1;
  const bool is_address = is_letter(line_[at]) && !is_letter(peek(end)) && peek(end) != '_';
  if (is_address && to_upper(line_[at]) == 'R' && is_digit(peek(end))) {
    return add(at, digits_end(end), TokenKind::variable);
  }
  if (is_address) {
    return read_word(at, 1);
  }
  while (is_name_part(peek(end))) {
    ++end;
  }
  const std::size_t next = skip_blanks(end);
  if (peek(next) == ':' && at_start(at)) {
    return add(at, next + 1, TokenKind::label);
  }
  std::size_t before = at;
  while (before > 0 && is_blank(line_[before - 1])) {
    --before;
  }
  const bool in_value =
      before > 0 && std::string_view("=+-*/(,[<>").find(line_[before - 1]) != std::string_view::npos;
  const bool is_operator = is_one_of(line_.substr(at, end - at), {"AND", "OR", "XOR", "NOT", "DIV", "MOD"});
  const bool set = peek(next) == '=' && peek(next + 1) != '=';
  const bool names_a_value = set || (in_value && peek(next) != '(' && !is_operator);
  return add(at, end, names_a_value ? TokenKind::variable : TokenKind::keyword);
}

std::size_t Syntax::read_heidenhain_name(std::size_t at) {
  std::size_t letters_end = at;
  while (is_letter(peek(letters_end)) || peek(letters_end) == '_') {
    ++letters_end;
  }
  std::size_t end = letters_end;
  while (is_name_part(peek(end))) {
    ++end;
  }
  const std::string_view letters = line_.substr(at, letters_end - at);
  const bool has_digits = end > letters_end;
  if (has_digits && is_one_of(letters, {"Q", "QL", "QR", "QS"})) {
    return add(at, end, TokenKind::variable);
  }
  if (is_one_of(letters, {"FMAX", "FAUTO", "FU", "FZ"})) {
    return add(at, end, TokenKind::feed);
  }
  if (is_one_of(letters, {"R", "RL", "RR", "DR", "PR", "PA", "IPR", "IPA"})) {
    return add(at, letters.size() == 1 ? end : letters_end, TokenKind::argument);
  }
  const bool increment = letters.size() == 2 && to_upper(letters[0]) == 'I';
  const bool has_value = is_number_part(peek(letters_end)) || (increment && is_axis(letters[1]));
  const bool is_xyz = letters.size() == 1 && to_upper(letters[0]) >= 'X' && to_upper(letters[0]) <= 'Z';
  const bool takes_q = to_upper(peek(letters_end)) == 'Q';
  if (is_xyz || ((letters.size() == 1 || increment) && (has_value || takes_q))) {
    return read_word(at, letters.size());
  }
  return add(at, std::max(end, at + 1), TokenKind::keyword);
}

}  // namespace feedscope::ui
