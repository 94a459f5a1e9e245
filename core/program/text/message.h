#pragma once

#include <string>
#include <string_view>

#include "core/base/message.h"

namespace feedscope {

/// Program text fit for a message: quoted, short, plain characters only.
std::string in_quotes(std::string_view text);

/// "G1", "G90.1"; `number` is ten times the G number.
std::string g_name(int number);

/// What to do where a work offset has no value: "G54.1 P3".
Message missing_offset_hint(std::string name);

}  // namespace feedscope
