#pragma once

#include <cstdint>
#include <string>

#include "core/program/text/message_codes.h"

namespace feedscope {

/// Thrown for an unreadable statement; the reader catches it at the end of the block and turns it into a
/// diagnostic.
struct ReadFault {
  MessageCode code;
  std::uint32_t column = 0;  ///< 1-based byte column
  std::string message;
  std::string hint;
};

}  // namespace feedscope
