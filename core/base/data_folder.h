#pragma once

#include <filesystem>

namespace feedscope {

/// Folder with machines/ and resources/: environment variable FEEDSCOPE_DATA if set, else ../share/feedscope
/// next to the executable's folder (an installed Feedscope), else the source tree. Throws InputError if the
/// one that applies has no folder machines/.
std::filesystem::path data_folder();

}  // namespace feedscope
