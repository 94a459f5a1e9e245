#include "core/program/sinumerik/language/program_index.h"

#include <algorithm>

#include "core/program/sinumerik/language/names.h"
#include "core/program/text/scanner.h"

namespace feedscope::sinumerik {

namespace {

/// Words that open a structure, and those that close it.
constexpr std::pair<std::string_view, std::string_view> pairs[] = {
    {"IF", "ENDIF"}, {"FOR", "ENDFOR"}, {"WHILE", "ENDWHILE"}, {"LOOP", "ENDLOOP"}, {"REPEAT", "UNTIL"},
};

bool jumps(std::string_view condition) {
  return upper_case(condition).find("GOTO") != std::string::npos;
}

/// Reads the digits from here on.
std::string_view digits(Scanner& scanner) {
  const std::string_view rest = scanner.rest();
  const std::size_t count = std::min(rest.find_first_not_of("0123456789"), rest.size());
  scanner.move_to(scanner.at() + count);
  return rest.substr(0, count);
}

/// Part of a line before its first word.
struct Prefix {
  std::string_view number;  ///< "N20", ":20"; may be empty
  std::string_view label;   ///< without its colon; may be empty
  Scanner behind;
};

Prefix prefix_of(std::string_view line) {
  Prefix prefix{.number = {}, .label = {}, .behind = Scanner(line)};
  Scanner& at = prefix.behind;
  const auto skip_delete = [&at] {
    if (at.take('/')) {
      digits(at);
    }
  };
  skip_delete();
  Scanner word = at;
  if ((word.take('N') || word.take(':')) && letters::is_digit(word.peek())) {
    digits(word);
    const std::size_t from = static_cast<std::size_t>(at.column() - 1);
    prefix.number = line.substr(from, word.at() - from);
    at = word;
  }
  skip_delete();
  word = at;
  const std::string_view name = word.name();
  if (name.size() > 1 && word.take(':')) {
    prefix.label = name;
    at = word;
  }
  return prefix;
}

/// Block numbers "N020" and ":20" are "N20".
std::string label_key(std::string_view label) {
  const bool numbered = label.size() > 1 && (letters::to_upper(label[0]) == 'N' || label[0] == ':') &&
                        label.find_first_not_of(" \t0123456789", 1) == std::string_view::npos;
  if (!numbered) {
    return upper_case(label);
  }
  const std::size_t first = label.find_first_not_of(" \t0", 1);
  return "N" + (first == std::string_view::npos ? "0" : std::string(label.substr(first)));
}

}  // namespace

Scanner first_statement(std::string_view line) {
  return prefix_of(line).behind;
}

std::string_view without_comment(std::string_view line) {
  bool inside_text = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '"') {
      inside_text = !inside_text;
    } else if (line[at] == ';' && !inside_text) {
      return line.substr(0, at);
    }
  }
  // An unclosed text contains no ";" on any control.
  return inside_text ? line.substr(0, line.find(';')) : line;
}

ProgramIndex::ProgramIndex(const SourceText& text) {
  sections_.push_back({.name = "", .main = false, .first = 1, .last = text.line_count()});
  std::vector<Open> open;
  for (std::uint32_t number = 1; number <= text.line_count(); ++number) {
    const std::string_view line = text.line(number);
    if (line.starts_with('%')) {
      add_head(line, number);
      open.clear();
    } else {
      add_line(without_comment(line), number, open);
    }
  }
}

void ProgramIndex::add_head(std::string_view line, std::uint32_t number) {
  Scanner scanner(line, 1);
  std::string name = upper_case(scanner.name());
  if (name.starts_with("_N_")) {
    name.erase(0, 3);
  }
  const bool main = name.ends_with("_MPF");
  if (main || name.ends_with("_SPF")) {
    name.resize(name.size() - 4);
  }
  const std::uint32_t last = sections_.back().last;
  sections_.back().last = number - 1;
  sections_.push_back({.name = name, .main = main, .first = number + 1, .last = last});
}

void ProgramIndex::add_line(std::string_view line, std::uint32_t number, std::vector<Open>& open) {
  const Prefix prefix = prefix_of(line);
  for (const std::string_view label : {prefix.number, prefix.label}) {
    if (!label.empty()) {
      labels_[label_key(label)].push_back(number);
    }
  }
  Scanner word = prefix.behind;
  const std::string_view name = word.name();
  for (const auto& [begin, end] : pairs) {
    const bool repeats_label = begin == "REPEAT" && !word.at_end();
    if (letters::same(name, begin) && !repeats_label && !(begin == "IF" && jumps(word.rest()))) {
      open.push_back({.end = end, .line = number, .middle = 0});
    } else if (letters::same(name, end)) {
      close(end, number, open);
    }
  }
  if (letters::same(name, "ELSE") && !open.empty() && open.back().end == "ENDIF") {
    open.back().middle = number;
  }
}

void ProgramIndex::close(std::string_view word, std::uint32_t number, std::vector<Open>& open) {
  if (open.empty() || open.back().end != word) {
    return;
  }
  const Structure all{.begin = open.back().line, .middle = open.back().middle, .end = number};
  for (const std::uint32_t line : {all.begin, all.middle, all.end}) {
    if (line > 0) {
      structures_[line] = all;
    }
  }
  open.pop_back();
}

const ProgramIndex::Section* ProgramIndex::section(std::string_view name) const {
  const auto found = std::find_if(sections_.begin() + 1, sections_.end(),
                                  [&](const Section& section) { return letters::same(section.name, name); });
  return found == sections_.end() ? nullptr : &*found;
}

const ProgramIndex::Section& ProgramIndex::section_of(std::uint32_t line) const {
  const auto behind =
      std::upper_bound(sections_.begin(), sections_.end(), line,
                       [](std::uint32_t at, const Section& section) { return at < section.first; });
  return *std::max(sections_.begin(), behind - 1);
}

const ProgramIndex::Section* ProgramIndex::main_section() const {
  const auto found =
      std::find_if(sections_.begin(), sections_.end(), [](const Section& section) { return section.main; });
  return found == sections_.end() ? nullptr : &*found;
}

const std::vector<std::uint32_t>* ProgramIndex::lines_of(std::string_view label) const {
  const auto found = labels_.find(label_key(label));
  return found == labels_.end() ? nullptr : &found->second;
}

std::uint32_t ProgramIndex::forward(std::string_view label, std::uint32_t from) const {
  const std::vector<std::uint32_t>* const lines = lines_of(label);
  if (lines == nullptr) {
    return 0;
  }
  const auto next = std::upper_bound(lines->begin(), lines->end(), from);
  return next != lines->end() && *next <= section_of(from).last ? *next : 0;
}

std::uint32_t ProgramIndex::backward(std::string_view label, std::uint32_t from) const {
  const std::vector<std::uint32_t>* const lines = lines_of(label);
  if (lines == nullptr) {
    return 0;
  }
  const auto behind = std::upper_bound(lines->begin(), lines->end(), from);
  return behind != lines->begin() && *(behind - 1) >= section_of(from).first ? *(behind - 1) : 0;
}

ProgramIndex::Structure ProgramIndex::structure(std::uint32_t line) const {
  const auto found = structures_.find(line);
  return found == structures_.end() ? Structure{} : found->second;
}

}  // namespace feedscope::sinumerik
