#pragma once

#include <string>
#include <string_view>

namespace feedscope {

/// The number that a line of a program bears: "N120", of conversational programs the "12" at its start; empty
/// for a line without one.
std::string block_number(std::string_view line);

}  // namespace feedscope
