#pragma once

#include <filesystem>

#include "ui/scene/picture.h"

namespace feedscope::test {

/// What is drawn by us alone, or laid out by the toolkit as well: whose version moves widgets by a pixel or
/// two.
enum class PictureOf { drawing, window };

/// 0 if `picture` looks as the baseline does. Else says why, leaves both and what differs in the folder
/// `results`, and gives 1.
int compare_with_baseline(const ui::Picture& picture, const std::filesystem::path& baseline,
                          const std::filesystem::path& results, PictureOf what = PictureOf::drawing);

}  // namespace feedscope::test
