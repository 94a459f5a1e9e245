#pragma once

#include <string>
#include <string_view>

#include "core/base/message.h"

namespace feedscope {

/// Program text for a message: quoted, short, plain characters only.
std::string in_quotes(std::string_view text);

/// "G1", "G90.1"; `number` is ten times the G number.
std::string g_name(int number);

/// Hint for a work offset without a value: "G54.1 P3".
Message missing_offset_hint(std::string name);

}  // namespace feedscope
