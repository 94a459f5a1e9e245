#include "core/models/grbl/grbl_line.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace feedscope {
namespace {

constexpr std::size_t longest = 79;  // characters of a line, without comments
constexpr std::string_view known_values = "FIJKLNPRSTXYZ";

std::string kept_characters(std::string_view text) {
  std::string kept;
  bool in_comment = false;
  for (const char c : text) {
    if (c == ';' && !in_comment) {
      break;
    }
    if (in_comment) {
      in_comment = c != ')';
    } else if (c == '(') {
      in_comment = true;
    } else if (c > ' ' && c != '/') {
      kept += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    } else if (static_cast<unsigned char>(c) >= 0x80) {
      kept += c;
    }
  }
  return kept;
}

/// Reads sign, digits and point; none without a digit.
std::optional<float> read_number(std::string_view& rest) {
  std::size_t end = !rest.empty() && (rest[0] == '-' || rest[0] == '+') ? 1 : 0;
  const std::size_t digits_from = end;
  bool point = false;
  std::size_t digits = 0;
  for (; end < rest.size(); ++end) {
    const bool digit = rest[end] >= '0' && rest[end] <= '9';
    if (!digit && (rest[end] != '.' || point)) {
      break;
    }
    digits += digit ? 1 : 0;
    point = point || !digit;
  }
  if (digits == 0) {
    return std::nullopt;
  }
  float value = 0;
  fast_float::from_chars(rest.data() + digits_from, rest.data() + end, value);
  const bool negative = rest[0] == '-';
  rest.remove_prefix(end);
  return negative ? -value : value;
}

}  // namespace

bool GrblLine::empty() const {
  return g.empty() && m.empty() && std::ranges::none_of(values, [](const auto& v) { return v.has_value(); });
}

std::string_view grbl_error_text(int number) {
  static constexpr std::pair<int, std::string_view> texts[]{
      {1, "a word must begin with a letter"},
      {2, "a letter has no number"},
      {3, "system commands are not part of a program"},
      {4, "the value must not be negative"},
      {11, "the line has more than 79 characters"},
      {20, "the command is not supported"},
      {21, "two commands of one group"},
      {22, "no feed is given"},
      {23, "the number of the command must be whole"},
      {24, "two commands both use the axis words"},
      {25, "a word is repeated"},
      {26, "axis words of the plane are missing"},
      {28, "a value is missing"},
      {29, "the work offset does not exist"},
      {30, "G53 needs G0 or G1"},
      {31, "axis words without a command that uses them"},
      {33, "the arc does not fit its end point"},
      {34, "the radius is smaller than half the distance of the ends"},
      {35, "centre offsets of the plane are missing"},
      {36, "a word is not used by any command of the line"},
      {37, "G43.1 takes Z only"},
      {38, "the tool number is too large"},
  };
  const auto* const found = std::ranges::find(texts, number, &std::pair<int, std::string_view>::first);
  return found == std::end(texts) ? std::string_view("the line is not accepted") : found->second;
}

std::optional<GrblError> read_grbl_line(std::string_view text, GrblLine& line) {
  line.g.clear();
  line.m.clear();
  line.values.fill(std::nullopt);
  const std::string kept = kept_characters(text);
  if (kept.size() > longest) {
    return GrblError{11};
  }
  std::string_view rest = kept;
  if (!rest.empty() && rest[0] == '$') {
    return GrblError{3, "$"};
  }
  while (!rest.empty()) {
    const char letter = rest[0];
    if (letter < 'A' || letter > 'Z') {
      return GrblError{1, std::string(1, letter)};
    }
    rest.remove_prefix(1);
    const std::optional<float> number = read_number(rest);
    if (!number) {
      return GrblError{2, std::string(1, letter)};
    }
    if (letter == 'G' || letter == 'M') {
      const float whole = std::trunc(*number);
      const int decimal = static_cast<int>(std::lround(100.0F * (*number - whole)));
      if (decimal % 10 != 0 || (letter == 'M' && decimal != 0)) {
        return GrblError{23, fmt::format("{}{}", letter, *number)};
      }
      if (letter == 'G') {
        line.g.push_back({static_cast<int>(whole), decimal / 10});
      } else {
        line.m.push_back(static_cast<int>(whole));
      }
      continue;
    }
    if (known_values.find(letter) == std::string_view::npos) {
      return GrblError{20, std::string(1, letter)};
    }
    std::optional<float>& value = line.values[static_cast<std::size_t>(letter - 'A')];
    if (value) {
      return GrblError{25, std::string(1, letter)};
    }
    if (*number < 0 && (letter == 'F' || letter == 'N' || letter == 'P' || letter == 'S' || letter == 'T')) {
      return GrblError{4, std::string(1, letter)};
    }
    value = number;
  }
  return std::nullopt;
}

}  // namespace feedscope
