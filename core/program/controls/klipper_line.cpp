#include "core/program/controls/klipper_line.h"

#include <fast_float/fast_float.h>

#include <vector>

namespace feedscope {
namespace {

bool is_key_letter(char c) {
  return (c >= 'A' && c <= 'Z') || c == '_';
}

std::string without_outer_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\f\v";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

}  // namespace

std::optional<double> KlipperLine::number(std::string_view key) const {
  const auto found = values.find(key);
  if (found == values.end() || found->second.empty()) {
    return std::nullopt;
  }
  std::string_view text = found->second;
  for (const char sign : {'=', '+'}) {
    text.remove_prefix(text.starts_with(sign) ? 1 : 0);
  }
  double value = 0;
  const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Splits a line into words: each run of letters with the text that follows it, up to a ";".
KlipperLine read_klipper_line(std::string_view text) {
  std::string raised(text.substr(0, text.find(';')));
  for (char& c : raised) {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  std::vector<std::pair<std::string, std::string>> parts;
  const std::string_view line = raised;
  std::size_t i = 0;
  while (i < line.size() && !is_key_letter(line[i]) && line[i] != '*') {
    ++i;
  }
  const bool begins_otherwise = !without_outer_blanks(line.substr(0, i)).empty();
  while (i < line.size()) {
    const std::size_t letters = i++;
    while (line[letters] != '*' && i < line.size() && is_key_letter(line[i])) {
      ++i;
    }
    const std::size_t value = i;
    while (i < line.size() && !is_key_letter(line[i]) && line[i] != '*') {
      ++i;
    }
    parts.emplace_back(std::string(line.substr(letters, value - letters)),
                       without_outer_blanks(line.substr(value, i - value)));
  }
  KlipperLine read;
  std::size_t first = 0;
  if (!parts.empty() && parts[0].first == "N") {
    first = 1;
  }
  if (first < parts.size()) {
    read.command = parts[first].first + parts[first].second;
  }
  if (begins_otherwise && first == 0 && !parts.empty()) {
    read.command = without_outer_blanks(line.substr(0, line.find(parts[0].first))) + read.command;
  }
  for (auto& [key, text_of_value] : parts) {
    read.values[std::move(key)] = std::move(text_of_value);
  }
  return read;
}

}  // namespace feedscope
