#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>

namespace feedscope {

// What this process asks of its system; posix/ and windows/ have a file for each. POSIX is tested on Linux;
// macOS and Windows are untested.

/// Call first in main(). Returns its arguments in UTF-8; standard streams then transfer bytes unchanged, and
/// a console shows UTF-8.
std::span<char*> start_process(int argc, char** argv);

int process_id();

/// Path of the running program; empty if the system does not provide it.
std::filesystem::path executable_path();

/// Value of an environment variable that names a file; nothing if it is unset or empty.
std::optional<std::filesystem::path> path_in_environment(const char* name);

/// Whether `stream` (stdout, stderr) is a terminal.
bool is_terminal(std::FILE* stream);

/// Whether the user may write to an existing file; if not, errno has the reason.
bool may_write(const std::filesystem::path& file);

/// As std::fopen(file, "rb").
std::FILE* open_to_read(const std::filesystem::path& file);
/// The same as a descriptor, for libraries that read files; negative if it cannot be opened, for the reason
/// in errno.
int descriptor_to_read(const std::filesystem::path& file);

/// Flushes a file to the disk, so that it is whole after a power cut. Returns 0, or the errno of the failure;
/// 0 also where the file system cannot, or the user may not open the file.
int flush_to_disk(const std::filesystem::path& file);

/// Returns memory to the system that the allocator would keep, where the allocator can.
void give_back_memory();

}  // namespace feedscope
