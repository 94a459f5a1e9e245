#pragma once

#include <filesystem>

namespace feedscope::part_files {

/// Has an unfinished file removed if a signal (hang-up, interrupt, quit, broken pipe, termination) ends the
/// process. `file` must not move in memory until forget(). Beyond 64 files at a time nothing is done.
void remember(const std::filesystem::path& file);
void forget(const std::filesystem::path& file);

}  // namespace feedscope::part_files
