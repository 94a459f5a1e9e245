#include "core/program/sinumerik/names.h"

#include <algorithm>

#include "core/program/text/scanner.h"

namespace feedscope::sinumerik {

std::string upper_case(std::string_view name) {
  std::string upper(name);
  std::transform(upper.begin(), upper.end(), upper.begin(), letters::to_upper);
  return upper;
}

}  // namespace feedscope::sinumerik
