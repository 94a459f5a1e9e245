#pragma once

#include <span>

namespace feedscope {

/// Parses the arguments, runs the command they name and prints errors to standard error.
/// Returns the exit code (exit_codes.h); never throws.
int run_command_line(std::span<char*> arguments);

}  // namespace feedscope
