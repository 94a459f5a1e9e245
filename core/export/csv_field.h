#pragma once

#include <string>

namespace feedscope {

/// Quoted where a comma, a quote or a line end would break the row.
std::string csv_field(const std::string& text);

/// Eleven digits, and no minus before zero; nothing where it is not a number.
std::string csv_number(double value);

}  // namespace feedscope
