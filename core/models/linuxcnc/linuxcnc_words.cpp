#include "core/models/linuxcnc/linuxcnc_words.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

namespace feedscope {
namespace {

/// Calls `take` for the letters and numbers of a line, without comments.
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

/// Effect of a line on the order of execution.
enum class Flow {
  straight,
  begins,  ///< a loop or a subprogram, or any O word
  leads_elsewhere,
};

bool is_word_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

Flow flow_of_word(std::string_view word) {
  constexpr std::array begin{"WHILE", "FOR", "LOOP", "REPEAT", "LBL", "DO"};
  constexpr std::array lead{"END", "GOTO", "IF", "ELSE", "UNTIL", "CALL", "RET", "FN", "CASE"};
  const auto starts = [&](const char* known) { return word.starts_with(known); };
  return std::ranges::any_of(begin, starts)  ? Flow::begins
         : std::ranges::any_of(lead, starts) ? Flow::leads_elsewhere
                                             : Flow::straight;
}

/// Flow by an O word, or by the words of other dialects; M97, M98 and M99.
Flow flow_of(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first != std::string_view::npos && (line[first] == 'o' || line[first] == 'O')) {
    return Flow::begins;
  }
  bool in_comment = false;
  for (std::size_t i = 0; i + 1 < line.size() && line[i] != ';'; ++i) {
    if (line[i] == '#' && line[i + 1] == '<') {  // a named parameter
      i = std::min(line.find('>', i), line.size());
      continue;
    }
    in_comment = (in_comment || line[i] == '(') && line[i] != ')';
    if (in_comment || !is_word_letter(line[i])) {
      continue;
    }
    if (!is_word_letter(line[i + 1])) {
      const bool calls = (line[i] == 'M' || line[i] == 'm') && i + 2 < line.size() && line[i + 1] == '9' &&
                         line[i + 2] >= '7' && line[i + 2] <= '9';
      if (calls) {
        return Flow::leads_elsewhere;
      }
      continue;
    }
    std::string word;
    for (; i < line.size() && is_word_letter(line[i]); ++i) {
      word += static_cast<char>(line[i] & ~0x20);  // in upper case
    }
    --i;
    if (word == "TOOL" || word == "CYCL") {  // their CALL returns at once
      return Flow::straight;
    }
    if (const Flow flow = flow_of_word(word); flow != Flow::straight) {
      return flow;
    }
  }
  return Flow::straight;
}

/// True for a comment that is shown to the operator.
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

bool switches_coolant(const SourceText& source) {
  bool found = false;
  for (std::uint32_t number = 1; number <= source.line_count() && !found; ++number) {
    const std::string_view line = source.line(number);
    if (line.find_first_of("mM") != std::string_view::npos) {
      for_each_word(line, [&](char letter, double value) {
        found = found || (letter == 'M' && (value == 7 || value == 8 || value == 9));
      });
    }
  }
  return found;
}

void LinuxCncWaits::take(std::uint32_t first, std::uint32_t last, Found& all) const {
  for (std::uint32_t number = first; number <= last; ++number) {
    const Found found = waits_of(toolpath_.source->line(number));
    all.count += found.count;
    all.spindle_starts = all.spindle_starts || found.spindle_starts;
  }
}

/// Adds the rest of the loop or subprogram after line_, and its lines before `line`.
void LinuxCncWaits::go_back_to(std::uint32_t line, Found& all) {
  const SourceText& source = *toolpath_.source;
  if (line_ + 1 < without_from_) {
    std::uint32_t leads = line_ + 1;
    while (leads <= source.line_count() && flow_of(source.line(leads)) == Flow::straight) {
      ++leads;
    }
    if (leads <= source.line_count()) {
      take(line_ + 1, leads - 1, all);
    } else {
      without_from_ = line_ + 1;
    }
  }
  std::uint32_t from = line;
  while (from > without_to_ + 1 && flow_of(source.line(from - 1)) == Flow::straight) {
    --from;
  }
  const bool found = from > without_to_ + 1;
  without_to_ = found ? without_to_ : std::max(without_to_, line - 1);
  take(found && flow_of(source.line(from - 1)) == Flow::begins ? from : line, line, all);
}

LinuxCncWaits::Found LinuxCncWaits::before(std::size_t i) {
  Found all;
  const std::uint32_t line = toolpath_.segments[i].line;
  if (!toolpath_.source || line == line_) {
    return all;
  }
  if (line < line_) {
    go_back_to(line, all);
    line_ = line;
    return all;
  }
  const SourceText& source = *toolpath_.source;
  std::uint32_t leads = line_ + 1;
  while (leads <= line && flow_of(source.line(leads)) == Flow::straight) {
    ++leads;
  }
  take(line_ + 1, leads - 1, all);
  if (leads <= line) {  // the program continued elsewhere
    std::uint32_t from = line;
    while (from > 1 && flow_of(source.line(from - 1)) == Flow::straight) {
      --from;
    }
    take(from, line, all);
  }
  line_ = line;
  return all;
}

}  // namespace feedscope
