#pragma once

#include <filesystem>

namespace feedscope {

/// The folder that holds machines/ and resources/: environment variable FEEDSCOPE_DATA if it is set, else
/// ../share/feedscope beside the executable's folder (an installed Feedscope), else the source tree.
/// Throws InputError if the one that applies has no folder machines/.
std::filesystem::path data_folder();

}  // namespace feedscope
