#include "core/program/sinumerik/language/names.h"

#include <algorithm>

#include "core/program/text/scanner.h"

namespace feedscope::sinumerik {

std::string upper_case(std::string_view name) {
  std::string upper(name);
  std::transform(upper.begin(), upper.end(), upper.begin(), letters::to_upper);
  return upper;
}

int linear_axis(std::string_view name) {
  const char letter = name.size() == 1 ? letters::to_upper(name[0]) : ' ';
  return letter >= 'X' && letter <= 'Z' ? letter - 'X' : -1;
}

}  // namespace feedscope::sinumerik
