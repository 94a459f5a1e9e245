#include "core/trace/trace_row.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace feedscope {
namespace {

constexpr std::string_view blanks = " \t";

std::string_view bare(std::string_view field) {
  const auto first = field.find_first_not_of(" \t\"");
  return first == std::string_view::npos ? std::string_view()
                                         : field.substr(first, field.find_last_not_of(" \t\"") - first + 1);
}

/// End of a quoted field at the start of `line` that is followed by a separator or the end; else 0.
std::size_t end_of_quotes(std::string_view line, char separator) {
  const std::string_view around = separator == '\t' ? " " : blanks;
  const auto open = line.find_first_not_of(around);
  if (open == std::string_view::npos || line[open] != '"') {
    return 0;
  }
  for (auto close = line.find('"', open + 1); close != std::string_view::npos;
       close = line.find('"', close + 1)) {
    const auto next = line.find_first_not_of(around, close + 1);
    if (next == std::string_view::npos || line[next] == separator) {
      return close + 1;
    }
  }
  return 0;
}

}  // namespace

void split_row(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  if (separator == ' ') {
    for (auto begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
      const auto end = line.find_first_of(blanks, begin);
      fields.push_back(line.substr(begin, end == std::string_view::npos ? end : end - begin));
      begin = line.find_first_not_of(blanks, end);
    }
    return;
  }
  for (;;) {
    const auto end = line.find(separator, end_of_quotes(line, separator));
    fields.push_back(bare(line.substr(0, end)));
    if (end == std::string_view::npos) {
      return;
    }
    line.remove_prefix(end + 1);
  }
}

std::optional<double> field_number(std::string_view field, char decimal) {
  if (field.starts_with('+')) {
    field.remove_prefix(1);
  }
  double value = 0;
  const auto result =
      fast_float::from_chars_advanced(field.data(), field.data() + field.size(), value,
                                      fast_float::parse_options(fast_float::chars_format::general, decimal));
  if (result.ec != std::errc() || result.ptr != field.data() + field.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

RowStyle find_row_style(const std::vector<std::string_view>& lines, char separator, char decimal) {
  RowStyle best;
  std::size_t most = 0;
  std::vector<std::string_view> fields;
  for (const char s : {'\t', ';', ',', ' '}) {
    for (const char d : {'.', ','}) {
      if ((separator != 0 && s != separator) || (decimal != 0 && d != decimal)) {
        continue;
      }
      std::size_t numbers = 0;
      for (const std::string_view line : lines) {
        split_row(line, s, fields);
        numbers += static_cast<std::size_t>(
            std::ranges::count_if(fields, [&](auto field) { return field_number(field, d).has_value(); }));
      }
      if (numbers > most || most == 0) {
        most = std::max(most, numbers);
        best = {s, d};
      }
    }
  }
  return {separator != 0 ? separator : best.separator, decimal != 0 ? decimal : best.decimal};
}

}  // namespace feedscope
