#include "core/models/linuxcnc/linuxcnc_words.h"

#include <cstdlib>
#include <string>
#include <string_view>

namespace feedscope {
namespace {

/// Letters and numbers of a line, comments aside.
template <typename Take>
void for_each_word(std::string_view text, const Take& take) {
  bool in_comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_comment) {
      in_comment = c != ')';
      continue;
    }
    if (c == ';') {
      return;
    }
    if (c == '(') {
      in_comment = true;
      continue;
    }
    const char letter = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (letter != 'M' && letter != 'S' && letter != 'G') {
      continue;
    }
    std::string number;
    std::size_t end = i + 1;
    while (end < text.size() &&
           (text[end] == ' ' || text[end] == '.' || (text[end] >= '0' && text[end] <= '9'))) {
      number += text[end] == ' ' ? "" : std::string(1, text[end]);
      ++end;
    }
    if (!number.empty()) {
      take(letter, std::strtod(number.c_str(), nullptr));
      i = end - 1;
    }
  }
}

/// An O word: of a loop, a branch, a subprogram or a call.
bool is_flow(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && (line[first] == 'o' || line[first] == 'O');
}

/// A comment that the operator is shown.
bool is_message(std::string_view line) {
  const std::size_t first = line.find('(');
  if (first == std::string_view::npos) {
    return false;
  }
  std::string word;
  for (std::size_t i = first + 1; i < line.size() && word.size() < 6; ++i) {
    const char c = line[i];
    word += c == ' ' ? "" : std::string(1, c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
  }
  return word.starts_with("msg,") || word.starts_with("debug,");
}

LinuxCncWaits::Found waits_of(std::string_view line) {
  LinuxCncWaits::Found found;
  found.count = is_message(line) ? 1 : 0;
  for_each_word(line, [&](char letter, double number) {
    const auto whole = static_cast<int>(number);
    if (letter == 'S') {
      ++found.count;
    } else if (letter == 'M') {
      const bool spindle = whole == 3 || whole == 4 || whole == 5;
      const bool coolant = whole == 7 || whole == 8 || whole == 9;
      const bool stops = whole == 0 || whole == 1;
      constexpr int of_tool_change = 2;
      found.count += whole == 6 ? of_tool_change : spindle || coolant || stops ? 1 : 0;
      found.spindle_starts = found.spindle_starts || whole == 3 || whole == 4;
    } else {
      const bool offsets = (whole >= 54 && whole <= 59) || whole == 92 || whole == 43 || whole == 49;
      found.count += offsets ? 1 : 0;
    }
  });
  return found;
}

}  // namespace

LinuxCncWaits::Found LinuxCncWaits::before(std::size_t i) {
  Found all;
  const std::uint32_t line = toolpath_.segments[i].line;
  if (!toolpath_.source || line == line_) {
    return all;
  }
  const SourceText& source = *toolpath_.source;
  const auto take = [&](std::uint32_t number) {
    const Found found = waits_of(source.line(number));
    all.count += found.count;
    all.spindle_starts = all.spindle_starts || found.spindle_starts;
  };
  const std::uint32_t last = line > line_ ? line : source.line_count();
  std::uint32_t number = line_ + 1;
  for (; number <= last && !is_flow(source.line(number)); ++number) {
    take(number);
  }
  if (number <= last) {  // it went on elsewhere
    std::uint32_t from = line;
    while (from > 1 && !is_flow(source.line(from - 1))) {
      --from;
    }
    for (; from <= line; ++from) {
      take(from);
    }
  }
  line_ = line;
  return all;
}

}  // namespace feedscope
