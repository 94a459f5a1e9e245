#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/base/message.h"

namespace feedscope {

/// Bytes of a file of at most `largest` MiB. `what` for messages: "machine file". Throws InputError with file
/// and reason: a folder, not readable, larger.
std::string file_text(const std::filesystem::path& file, Translatable what, std::size_t largest);

}  // namespace feedscope
