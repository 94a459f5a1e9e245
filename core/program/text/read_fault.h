#pragma once

#include <cstdint>
#include <string>

#include "core/program/text/message_codes.h"

namespace feedscope {

/// Thrown where a statement cannot be read; the reader catches it at the end of the block and makes it a
/// diagnostic.
struct ReadFault {
  MessageCode code;
  std::uint32_t column = 0;  ///< 1-based byte column
  std::string message;
  std::string hint;
};

}  // namespace feedscope
