#include "ui/program_text/line_cells.h"

#include <algorithm>
#include <array>

namespace feedscope::ui {

namespace {

constexpr std::uint32_t tab_width = 8;
constexpr char32_t replacement = 0xFFFD;

struct Decoded {
  char32_t code = replacement;
  std::uint32_t bytes = 1;
};

Decoded decode_utf8(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  const unsigned char lead = byte(0);
  const std::uint32_t bytes = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (at + bytes > text.size()) {
    return {};
  }
  char32_t code = bytes == 1 ? lead : lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    code = code << 6 | (byte(i) & 0x3FU);
  }
  return {code > 0x10FFFF || QChar::isSurrogate(code) ? replacement : code, bytes};
}

struct CodeRange {
  char32_t first, last;
};

/// Unicode's East_Asian_Width W and F, by blocks.
constexpr std::array<CodeRange, 9> wide_ranges{{{0x1100, 0x115F},
                                                {0x2E80, 0x303E},
                                                {0x3041, 0xA4CF},
                                                {0xAC00, 0xD7A3},
                                                {0xF900, 0xFAFF},
                                                {0xFE30, 0xFE6F},
                                                {0xFF00, 0xFF60},
                                                {0xFFE0, 0xFFE6},
                                                {0x20000, 0x3FFFD}}};

std::uint32_t width_of(char32_t code) {
  if (code < 0x300) {
    return 1;
  }
  const QChar::Category category = QChar::category(code);
  if (category == QChar::Mark_NonSpacing || category == QChar::Mark_Enclosing) {
    return 0;
  }
  const bool wide = std::ranges::any_of(
      wide_ranges, [&](const CodeRange& range) { return code >= range.first && code <= range.last; });
  return wide ? 2 : 1;
}

bool is_plain(std::string_view line) {
  return std::ranges::all_of(line, [](char c) { return c != '\t' && static_cast<unsigned char>(c) < 0x80; });
}

}  // namespace

LineCells::LineCells(std::string_view line, Encoding encoding)
    : line_(line), count_(static_cast<std::uint32_t>(line.size())) {
  if (line.size() > longest_decoded || is_plain(line)) {
    return;
  }
  characters_.reserve(line.size());
  count_ = 0;
  for (std::uint32_t at = 0; at < line.size();) {
    const Decoded character =
        encoding == Encoding::utf8 ? decode_utf8(line, at) : Decoded{static_cast<unsigned char>(line[at]), 1};
    characters_.push_back({at, count_, character.code});
    at += character.bytes;
    count_ += character.code == '\t' ? tab_width - count_ % tab_width : width_of(character.code);
  }
}

std::size_t LineCells::character_of(std::uint32_t byte) const {
  const auto after = std::ranges::upper_bound(characters_, byte, {}, &Character::byte);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - characters_.begin() - 1, 0));
}

std::uint32_t LineCells::cell_of(std::uint32_t byte) const {
  if (byte >= line_.size()) {
    return count_;
  }
  return characters_.empty() ? byte : characters_[character_of(byte)].cell;
}

std::uint32_t LineCells::byte_at(std::uint32_t cell) const {
  if (cell >= count_) {
    return static_cast<std::uint32_t>(line_.size());
  }
  if (characters_.empty()) {
    return cell;
  }
  auto found = std::ranges::upper_bound(characters_, cell, {}, &Character::cell) - 1;
  while (found != characters_.begin() && (found - 1)->cell == found->cell) {  // a combining mark on it
    --found;
  }
  return found->byte;
}

std::vector<LineCells::Run> LineCells::runs(std::uint32_t from, std::uint32_t to) const {
  const auto end = std::min(to, static_cast<std::uint32_t>(line_.size()));
  if (from >= end) {
    return {};
  }
  if (characters_.empty()) {
    return {{QString::fromLatin1(line_.data() + from, end - from), from}};
  }
  std::vector<Run> runs;
  std::uint32_t next_cell = 0;
  for (std::size_t i = character_of(from); i < characters_.size() && characters_[i].byte < end; ++i) {
    const Character& character = characters_[i];
    if (character.code == '\t') {
      continue;
    }
    const std::uint32_t width = width_of(character.code);
    if (runs.empty() || character.cell != next_cell || width == 2) {
      runs.push_back({{}, character.cell});
    }
    runs.back().text += QStringView(QChar::fromUcs4(character.code));
    next_cell = width == 2 ? 0 : character.cell + width;
  }
  return runs;
}

}  // namespace feedscope::ui
