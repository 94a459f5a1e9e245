#pragma once

#include <cstdint>

#include "core/program/sinumerik/language/values.h"
#include "core/program/sinumerik/language/words.h"

namespace feedscope::sinumerik {

/// Reads the value of an address after its "=": an expression, or AC(), IC(), DIC() and similar around one.
/// `column`: of the address. Throws ReadFault.
BlockWords::Value read_coordinate(Values& values, Scanner& scanner, std::uint32_t column);

}  // namespace feedscope::sinumerik
