#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace feedscope {

/// Parts of a line between separators, without blanks and quotes around them, in which a separator may stand;
/// ' ' as separator stands for any number of blanks and tabs.
void split_row(std::string_view line, char separator, std::vector<std::string_view>& fields);

/// A finite number that fills the whole field; `decimal`: '.' or ','.
std::optional<double> field_number(std::string_view field, char decimal);

/// How the fields of a table are parted.
struct RowStyle {
  char separator = ' ';
  char decimal = '.';
};
/// The style in which most of the fields of some lines are numbers; those given are kept (0: found).
RowStyle find_row_style(const std::vector<std::string_view>& lines, char separator, char decimal);

}  // namespace feedscope
