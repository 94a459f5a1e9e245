#include "app/picture_size.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "core/base/error.h"

namespace feedscope {

ui::PictureSize parse_picture_size(const std::string& text) {
  ui::PictureSize size;
  const char* const end = text.data() + text.size();
  const auto [by, width_error] = std::from_chars(text.data(), end, size.width);
  const bool has_by = width_error == std::errc() && by != end && (*by == 'x' || *by == 'X');
  const auto [rest, height_error] = has_by ? std::from_chars(by + 1, end, size.height)
                                           : std::from_chars_result{by, std::errc::invalid_argument};
  if (height_error != std::errc() || rest != end) {
    throw InputError(
        fmt::format("--size '{}' is no size; give width and height in pixels, as 1280x960", text));
  }
  for (const int side : {size.width, size.height}) {
    if (side < ui::least_picture_side || side > ui::largest_picture_side) {
      throw InputError(fmt::format("--size '{}': {} pixels is out of bounds; each side may have {} to {}",
                                   text, side, ui::least_picture_side, ui::largest_picture_side));
    }
  }
  return size;
}

}  // namespace feedscope
