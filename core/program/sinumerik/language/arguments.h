#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/program/sinumerik/language/variables.h"

namespace feedscope::sinumerik {

/// One argument of a call.
struct Argument {
  std::optional<double> number;     ///< none: not given, or a text
  std::optional<std::string> text;  ///< none: not given, or a number
  std::string variable;             ///< the variable that is the whole argument; else empty
  std::optional<Variable> array;    ///< its elements, if it is an array
};

using Arguments = std::vector<Argument>;

/// Number at a place; `missing` if there is none.
inline double number_at(const Arguments& arguments, std::size_t place, double missing = 0) {
  return place < arguments.size() ? arguments[place].number.value_or(missing) : missing;
}
inline std::optional<double> given_at(const Arguments& arguments, std::size_t place) {
  return place < arguments.size() ? arguments[place].number : std::nullopt;
}

}  // namespace feedscope::sinumerik
