#pragma once

#include <cstdio>
#include <filesystem>

namespace feedscope {

// What the system knows of this process: tried on Linux; the parts for macOS and Windows are untested.

int process_id();

/// Of the running program; empty where the system does not tell it.
std::filesystem::path executable_path();

/// Whether somebody reads `stream` (stdout, stderr) as it is written.
bool is_terminal(std::FILE* stream);

/// Whether the user may write to a file that is there; if not, errno says why.
bool may_write(const std::filesystem::path& file);

}  // namespace feedscope
