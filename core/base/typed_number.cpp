#include "core/base/typed_number.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <system_error>

namespace feedscope {
namespace {

std::optional<double> plain_number(std::string_view text) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  double number = 0;
  const auto result = fast_float::from_chars(begin, end, number);
  const bool whole = result.ec == std::errc() && result.ptr == end;
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::string replaced(std::string_view text, std::string_view with) {
  std::string out;
  for (const char c : text) {
    out += c == ',' ? std::string(with) : std::string(1, c);
  }
  return out;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether the comma may group thousands as in "1,000": one to three digits that do not begin with 0, then
/// exactly three.
bool may_group_thousands(std::string_view text) {
  const std::string_view digits = text.substr(text.find_first_not_of("+-"));
  const std::size_t comma = digits.find(',');
  const std::string_view after = digits.substr(comma + 1);
  const auto count = static_cast<std::size_t>(std::ranges::find_if_not(after, is_digit) - after.begin());
  return comma >= 1 && comma <= 3 && digits.front() != '0' && count == 3;
}

/// Whether numbers with decimal points are separated by commas: "0.01,0.05".
bool is_list(std::string_view text) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (!plain_number(text.substr(begin, end - begin))) {
      return false;
    }
    begin = end + 1;
  }
  return true;
}

}  // namespace

std::string without_thousands_separators(std::string_view text) {
  const std::size_t sign = text.find_first_not_of("+-");
  const std::size_t first = text.find_first_of(".,");
  if (sign == std::string_view::npos || first == std::string_view::npos || first <= sign ||
      first > sign + 3 || text[sign] == '0') {
    return {};
  }
  std::string plain(text.substr(0, first));
  std::size_t at = first;
  for (; at < text.size() && text[at] == text[first]; at += 4) {  // ",000"
    const std::string_view group = text.substr(at + 1, 3);
    if (group.size() < 3 || !std::ranges::all_of(group, is_digit)) {
      return {};
    }
    plain += group;
  }
  if (at < text.size() && (text[at] == '.' || text[at] == ',')) {
    plain += '.';
    ++at;
  }
  plain += text.substr(at);
  return plain_number(plain) ? plain : std::string();
}

TypedNumber typed_number(std::string_view text) {
  const auto commas = std::ranges::count(text, ',');
  if (commas == 0) {
    return {plain_number(text), {}};
  }
  const std::string with_point = replaced(text, ".");
  if (commas > 1 || text.find('.') != std::string_view::npos) {
    const std::string plain = without_thousands_separators(text);
    return {
        std::nullopt,
        !plain.empty()
            ? message(NC_("core", "a number has one decimal separator and no thousands separators; write {}"),
                      plain)
        : is_list(text) ? NC_("core", "one number is expected here, not several")
                        : Message()};
  }
  const std::optional<double> value = plain_number(with_point);
  if (value && may_group_thousands(text)) {
    return {std::nullopt,
            message(NC_("core", "the comma could be a decimal or a thousands separator; write {} or {}"),
                    with_point, replaced(text, ""))};
  }
  return {value, {}};
}

TypedNumber typed_list_number(std::string_view text) {
  if (text.find(',') == std::string_view::npos) {
    return typed_number(text);
  }
  if (text.find('.') != std::string_view::npos) {
    return {std::nullopt,
            message(NC_("core", "a comma does not separate values here; write \"{}\" in quotes"),
                    replaced(text, ";"))};
  }
  return {std::nullopt, message(NC_("core",
                                    "the comma could be a decimal separator or separate values; write {} for "
                                    "one value, \"{}\" in quotes for several"),
                                replaced(text, "."), replaced(text, ";"))};
}

}  // namespace feedscope
