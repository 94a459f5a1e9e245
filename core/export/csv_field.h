#pragma once

#include <string>

namespace feedscope {

/// Quotes a text with a comma, a quote or a line end, which would break the row.
std::string csv_field(const std::string& text);

/// Eleven digits, no negative zero; empty for NaN.
std::string csv_number(double value);

}  // namespace feedscope
