#include "core/program/controls/grbl_line.h"

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

Translatable grbl_error_text(int number) {
  static constexpr std::pair<int, Translatable> texts[]{
      {1, NC_("core", "a word must begin with a letter")},
      {2, NC_("core", "a letter has no number")},
      {3, NC_("core", "system commands are not part of a program")},
      {4, NC_("core", "the value must not be negative")},
      {11, NC_("core", "the line has more than 79 characters")},
      {20, NC_("core", "the command is not supported")},
      {21, NC_("core", "two commands of one group")},
      {22, NC_("core", "no feed is given")},
      {23, NC_("core", "the number of the command must be whole")},
      {24, NC_("core", "two commands both use the axis words")},
      {25, NC_("core", "a word is repeated")},
      {26, NC_("core", "axis words of the plane are missing")},
      {28, NC_("core", "a value is missing")},
      {29, NC_("core", "the work offset does not exist")},
      {30, NC_("core", "G53 needs G0 or G1")},
      {31, NC_("core", "axis words without a command that uses them")},
      {33, NC_("core", "the arc does not fit its end point")},
      {34, NC_("core", "the radius is smaller than half the distance of the ends")},
      {35, NC_("core", "centre offsets of the plane are missing")},
      {36, NC_("core", "a word is not used by any command of the line")},
      {37, NC_("core", "G43.1 takes Z only")},
      {38, NC_("core", "the tool number is too large")},
  };
  const auto* const found = std::ranges::find(texts, number, &std::pair<int, Translatable>::first);
  return found == std::end(texts) ? NC_("core", "the line is not accepted") : found->second;
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
    return GrblError{3, Message::as_written("$")};
  }
  while (!rest.empty()) {
    const char letter = rest[0];
    if (letter < 'A' || letter > 'Z') {
      return GrblError{1, Message::as_written(std::string(1, letter))};
    }
    rest.remove_prefix(1);
    const std::optional<float> number = read_number(rest);
    if (!number) {
      return GrblError{2, Message::as_written(std::string(1, letter))};
    }
    if (letter == 'G' || letter == 'M') {
      const float whole = std::trunc(*number);
      const int decimal = static_cast<int>(std::lround(100.0F * (*number - whole)));
      if (decimal % 10 != 0 || (letter == 'M' && decimal != 0)) {
        return GrblError{23, Message::as_written(fmt::format("{}{}", letter, *number))};
      }
      if (letter == 'G') {
        line.g.push_back({static_cast<int>(whole), decimal / 10});
      } else {
        line.m.push_back(static_cast<int>(whole));
      }
      continue;
    }
    if (known_values.find(letter) == std::string_view::npos) {
      return GrblError{20, Message::as_written(std::string(1, letter))};
    }
    std::optional<float>& value = line.values[static_cast<std::size_t>(letter - 'A')];
    if (value) {
      return GrblError{25, Message::as_written(std::string(1, letter))};
    }
    if (*number < 0 && (letter == 'F' || letter == 'N' || letter == 'P' || letter == 'S' || letter == 'T')) {
      return GrblError{4, Message::as_written(std::string(1, letter))};
    }
    value = number;
  }
  return std::nullopt;
}

}  // namespace feedscope
