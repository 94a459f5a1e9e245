#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace feedscope {

/// Splits a line at separators and removes surrounding blanks and quotes; quoted fields may contain
/// separators. ' ' as separator means any number of blanks and tabs.
void split_row(std::string_view line, char separator, std::vector<std::string_view>& fields);

/// A finite number that fills the whole field; `decimal`: '.' or ','.
std::optional<double> field_number(std::string_view field, char decimal);

/// Syntax of the fields in a table.
struct RowStyle {
  char separator = ' ';
  char decimal = '.';
};
/// Style in which most fields of some lines are numbers; given values are kept (0: detect).
RowStyle find_row_style(const std::vector<std::string_view>& lines, char separator, char decimal);

}  // namespace feedscope
