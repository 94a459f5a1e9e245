#pragma once

#include <cstdint>

#include "core/base/message.h"
#include "core/program/text/message_codes.h"

namespace feedscope {

/// Thrown where a statement cannot be read; the reader catches it at the end of the block and makes it a
/// diagnostic.
struct ReadFault {
  MessageCode code;
  std::uint32_t column = 0;  ///< 1-based byte column
  Message message;
  Message hint;
};

}  // namespace feedscope
