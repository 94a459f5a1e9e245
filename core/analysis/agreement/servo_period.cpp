#include "core/analysis/agreement/servo_period.h"

namespace feedscope {

double servo_period_of(const Setup& setup) {
  constexpr const char* key = "servo_period_s";
  return setup.settings.has(key)           ? setup.settings.number(key)
         : setup.machine.settings.has(key) ? setup.machine.settings.number(key)
                                           : 0;
}

}  // namespace feedscope
