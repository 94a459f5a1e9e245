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

LinuxCncWaits::Found waits_of(std::string_view line) {
  LinuxCncWaits::Found found;
  for_each_word(line, [&](char letter, double number) {
    const auto whole = static_cast<int>(number);
    if (letter == 'S') {
      ++found.count;
    } else if (letter == 'M') {
      const bool spindle = whole == 3 || whole == 4 || whole == 5;
      const bool coolant = whole == 7 || whole == 8 || whole == 9;
      const bool stops = whole == 0 || whole == 1 || whole == 6;
      found.count += spindle || coolant || stops ? 1 : 0;
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
  if (!toolpath_.source || line <= line_) {
    line_ = line;
    return all;
  }
  for (std::uint32_t number = line_ + 1; number <= line; ++number) {
    const Found found = waits_of(toolpath_.source->line(number));
    all.count += found.count;
    all.spindle_starts = all.spindle_starts || found.spindle_starts;
  }
  line_ = line;
  return all;
}

}  // namespace feedscope
