#include "core/machine/work_offsets.h"

#include <fmt/format.h>

#include <cctype>
#include <optional>

namespace feedscope {

namespace {

/// Removes an unsigned number with at most one decimal from the start of `text`.
std::optional<std::string> take_number(std::string_view& text) {
  constexpr std::size_t max_digits = 4;
  std::size_t end = 0;
  while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) {
    ++end;
  }
  if (end == 0 || end > max_digits) {
    return std::nullopt;
  }
  std::string number = fmt::format("{}", std::stoi(std::string(text.substr(0, end))));
  if (end + 1 < text.size() && text[end] == '.' &&
      std::isdigit(static_cast<unsigned char>(text[end + 1])) != 0) {
    number += text[end + 1] == '0' ? std::string() : fmt::format(".{}", text[end + 1]);
    end += 2;
  }
  text.remove_prefix(end);
  return number;
}

}  // namespace

std::string WorkOffsets::key(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (c != ' ' && c != '\t') {
      plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  std::string_view rest = plain;
  if (!rest.starts_with('G')) {
    return "";
  }
  rest.remove_prefix(1);
  const std::optional<std::string> code = take_number(rest);
  if (!code) {
    return "";
  }
  if (rest.empty()) {
    return "G" + *code;
  }
  if (!rest.starts_with('P')) {
    return "";
  }
  rest.remove_prefix(1);
  const std::optional<std::string> further = take_number(rest);
  return further && rest.empty() ? fmt::format("G{} P{}", *code, *further) : "";
}

}  // namespace feedscope
