#pragma once

#include <cstdint>
#include <string>

#include "core/program/sinumerik/language/arguments.h"

namespace feedscope::sinumerik {

/// Call of a subprogram or cycle in a block.
struct SubprogramCall {
  std::string name;          ///< as written
  std::uint32_t column = 0;  ///< of its name
  Arguments arguments = {};
};

}  // namespace feedscope::sinumerik
