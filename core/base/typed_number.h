#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace feedscope {

/// A typed number, on the command line, in a setting or a field.
struct TypedNumber {
  std::optional<double> value;  ///< none if it cannot be read
  Message problem;              ///< reason and advice without a value; "" if it is not a number
};

/// Reads one finite number, possibly with an exponent ("1e-3"). A point is always the decimal sign. A single
/// comma is the decimal sign if it cannot be anything else ("0,05", "12,5"); "1,000" could be one or one
/// thousand and is refused, as is every number with several commas, or a comma and a point.
TypedNumber typed_number(std::string_view text);
/// A number without its thousands separators: "1000.5" for "1.000,5" and "1,000.5". "" for a text whose
/// points and commas do not group thousands.
std::string without_thousands_separators(std::string_view text);

/// Reads one number of a list. Lists are separated by blanks or semicolons; a comma could be the decimal sign
/// or a separator and is refused.
TypedNumber typed_list_number(std::string_view text);

}  // namespace feedscope
