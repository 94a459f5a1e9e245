#pragma once

#include <cstdio>
#include <filesystem>

namespace feedscope {

// System data of this process: tested on Linux; the parts for macOS and Windows are untested.

int process_id();

/// Path of the running program; empty if the system does not provide it.
std::filesystem::path executable_path();

/// Whether `stream` (stdout, stderr) is a terminal.
bool is_terminal(std::FILE* stream);

/// Whether the user may write to an existing file; if not, errno has the reason.
bool may_write(const std::filesystem::path& file);

}  // namespace feedscope
