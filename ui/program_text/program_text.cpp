#include "ui/program_text/program_text.h"

#include <algorithm>

#include "core/program/text/scanner.h"

namespace feedscope::ui {

namespace {

enum class CharacterClass { blank, word, sign };

CharacterClass class_of(char c) {
  if (letters::is_blank(c)) {
    return CharacterClass::blank;
  }
  const bool word = letters::is_name_part(c) || c == '.' || static_cast<unsigned char>(c) >= 0x80;
  return word ? CharacterClass::word : CharacterClass::sign;
}

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80;
}

}  // namespace

std::string_view ProgramText::line(std::uint32_t number) const {
  return program_ == nullptr ? std::string_view() : program_->source->line(number);
}

std::size_t ProgramText::longest_line() const {
  std::size_t longest = 0;
  for (std::uint32_t i = 1; i <= line_count(); ++i) {
    longest = std::max(longest, line(i).size());
  }
  return longest;
}

TextPlace ProgramText::clamped(TextPlace place) const {
  if (place.line > line_count()) {
    return end();
  }
  place.line = std::max(place.line, 1U);
  const std::string_view text = line(place.line);
  place.byte = std::min(place.byte, static_cast<std::uint32_t>(text.size()));
  while (encoding() == Encoding::utf8 && place.byte < text.size() && place.byte > 0 &&
         continues(text[place.byte])) {
    --place.byte;
  }
  return place;
}

TextPlace ProgramText::end() const {
  const std::uint32_t last = line_count();
  return last == 0 ? TextPlace() : TextPlace{last, static_cast<std::uint32_t>(line(last).size())};
}

TextPlace ProgramText::before(TextPlace place) const {
  if (place.byte > 0) {
    return clamped({place.line, place.byte - 1});
  }
  return place.line > 1 ? clamped({place.line - 1, ~0U}) : place;
}

TextPlace ProgramText::after(TextPlace place) const {
  const std::string_view text = line(place.line);
  if (place.byte >= text.size()) {
    return place.line < line_count() ? TextPlace{place.line + 1, 0} : place;
  }
  ++place.byte;
  while (encoding() == Encoding::utf8 && place.byte < text.size() && continues(text[place.byte])) {
    ++place.byte;
  }
  return place;
}

TextPlace ProgramText::word_before(TextPlace place) const {
  if (place.byte == 0) {
    return before(place);
  }
  const std::string_view text = line(place.line);
  while (place.byte > 0 && letters::is_blank(text[place.byte - 1])) {
    --place.byte;
  }
  if (place.byte > 0) {
    const CharacterClass wanted = class_of(text[place.byte - 1]);
    while (place.byte > 0 && class_of(text[place.byte - 1]) == wanted) {
      --place.byte;
    }
  }
  return place;
}

TextPlace ProgramText::word_after(TextPlace place) const {
  const std::string_view text = line(place.line);
  if (place.byte >= text.size()) {
    return after(place);
  }
  const CharacterClass wanted = class_of(text[place.byte]);
  while (place.byte < text.size() && class_of(text[place.byte]) == wanted) {
    ++place.byte;
  }
  while (place.byte < text.size() && letters::is_blank(text[place.byte])) {
    ++place.byte;
  }
  return place;
}

TextRange ProgramText::word_at(TextPlace place) const {
  const std::string_view text = line(place.line);
  if (text.empty()) {
    return {place, place};
  }
  const std::size_t at = std::min<std::size_t>(place.byte, text.size() - 1);
  const CharacterClass wanted = class_of(text[at]);
  std::size_t from = at;
  std::size_t to = at;
  while (from > 0 && class_of(text[from - 1]) == wanted) {
    --from;
  }
  while (to < text.size() && class_of(text[to]) == wanted) {
    ++to;
  }
  return {{place.line, static_cast<std::uint32_t>(from)}, {place.line, static_cast<std::uint32_t>(to)}};
}

QString ProgramText::decoded(std::string_view part) const {
  const auto size = static_cast<qsizetype>(part.size());
  return encoding() == Encoding::utf8 ? QString::fromUtf8(part.data(), size)
                                      : QString::fromLatin1(part.data(), size);
}

QString ProgramText::text(TextRange range) const {
  const TextPlace begin = clamped(range.begin);
  const TextPlace end = clamped(range.end);
  if (!(begin < end)) {
    return {};
  }
  if (begin.line == end.line) {
    return decoded(line(begin.line).substr(begin.byte, end.byte - begin.byte));
  }
  QString text = decoded(line(begin.line).substr(begin.byte)) + '\n';
  for (std::uint32_t i = begin.line + 1; i < end.line; ++i) {
    text += decoded(line(i)) + '\n';
  }
  return text + decoded(line(end.line).substr(0, end.byte));
}

}  // namespace feedscope::ui
