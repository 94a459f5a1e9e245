#pragma once

#include <string>
#include <vector>

#include "app/command_table.h"

namespace feedscope {

/// feedscope(1) for man, in roff.
std::string man_page(const std::vector<CommandRow>& commands);

}  // namespace feedscope
