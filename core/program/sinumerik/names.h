#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace feedscope::sinumerik {

/// Names are the same in upper and lower case.
std::string upper_case(std::string_view name);

/// 0 to 2 for X, Y, Z; -1 for other axes.
int linear_axis(std::string_view name);

/// "AC_TIMER", "AC_TIME" ...: what the control measures while it runs, 0 while a program is read.
inline bool is_timer(std::string_view name) {
  return upper_case(name).starts_with("AC_TIM");
}

/// For DiagnosticLog: different names are different kinds.
inline int kind_of(std::string_view name) {
  return static_cast<int>(std::hash<std::string>{}(upper_case(name)) & 0x7fffffffU);
}

}  // namespace feedscope::sinumerik
