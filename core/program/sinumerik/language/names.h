#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace feedscope::sinumerik {

/// Upper-case form of a name; upper and lower case are the same.
std::string upper_case(std::string_view name);

/// 0 to 2 for X, Y, Z; -1 for other axes.
int linear_axis(std::string_view name);

/// True for "AC_TIMER", "AC_TIME" ...: measurements of the running control, 0 while a program is read.
inline bool is_timer(std::string_view name) {
  return upper_case(name).starts_with("AC_TIM");
}

/// For DiagnosticLog: different names are different kinds.
inline int kind_of(std::string_view name) {
  return static_cast<int>(std::hash<std::string>{}(upper_case(name)) & 0x7fffffffU);
}

}  // namespace feedscope::sinumerik
