#pragma once

#include <cstdint>

#include "core/base/message.h"
#include "core/program/text/message_codes.h"

namespace feedscope {

/// Thrown for an unreadable statement; the reader catches it at the end of the block and turns it into a
/// diagnostic.
struct ReadFault {
  MessageCode code;
  std::uint32_t column = 0;  ///< 1-based byte column
  Message message;
  Message hint;
};

}  // namespace feedscope
