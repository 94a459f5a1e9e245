#pragma once

#include <string>
#include <string_view>

namespace feedscope {

/// Block number of a line of a program: "N120", or in conversational programs the "12" at its start; empty
/// for a line without one.
std::string block_number(std::string_view line);

}  // namespace feedscope
