#pragma once

#include <string>
#include <vector>

#include "app/command_table.h"

namespace feedscope {

/// Names that completion() takes.
std::vector<std::string> completed_shells();

/// Script with which a shell (bash, zsh, fish) completes commands, options and values. Throws InputError for
/// another shell.
std::string completion(const std::vector<CommandRow>& commands, const std::string& shell);

}  // namespace feedscope
