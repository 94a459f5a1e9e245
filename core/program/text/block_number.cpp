#include "core/program/text/block_number.h"

#include <algorithm>

namespace feedscope {

std::string block_number(std::string_view line) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  const auto drop = [&](const auto& unwanted) {
    line.remove_prefix(static_cast<std::size_t>(std::ranges::find_if_not(line, unwanted) - line.begin()));
  };
  drop([&](char c) { return is_blank(c) || c == '/'; });
  const bool has_letter = !line.empty() && (line[0] == 'N' || line[0] == 'n');
  if (has_letter) {
    line.remove_prefix(1);
    drop(is_blank);
  }
  const auto end = std::ranges::find_if_not(line, is_digit);
  const std::string digits(line.begin(), end);
  const bool ends = end == line.end() || is_blank(*end) || has_letter;
  return digits.empty() || !ends ? std::string() : (has_letter ? "N" : "") + digits;
}

}  // namespace feedscope
