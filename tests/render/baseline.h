#pragma once

#include <filesystem>

#include "ui/scene/picture.h"

namespace feedscope::test {

/// 0 if `picture` looks as the baseline does. Else says why, leaves both and what differs in the folder
/// `results`, and gives 1.
int compare_with_baseline(const ui::Picture& picture, const std::filesystem::path& baseline,
                          const std::filesystem::path& results);

}  // namespace feedscope::test
