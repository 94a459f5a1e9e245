#pragma once

#include <string>

#include "ui/scene/picture.h"

namespace feedscope {

/// Reads a --size, "800x600". Throws InputError if it is none or a side is out of bounds.
ui::PictureSize parse_picture_size(const std::string& text);

}  // namespace feedscope
