#include "app/picture_size.h"

#include <fmt/format.h>

#include <QPageSize>
#include <charconv>
#include <cmath>
#include <system_error>

#include "core/base/error.h"
#include "core/base/nearest_name.h"

namespace feedscope {
namespace {

const std::map<std::string, QPageSize::PageSizeId> sheets{
    {"A2", QPageSize::A2}, {"A3", QPageSize::A3}, {"A4", QPageSize::A4},
    {"A5", QPageSize::A5}, {"A6", QPageSize::A6}, {"Letter", QPageSize::Letter}};

std::vector<std::string> sheet_names() {
  std::vector<std::string> names;
  for (const auto& [name, id] : sheets) {
    names.push_back(name);
    names.push_back(name + "-portrait");
  }
  return names;
}

void check_sides(const std::string& text, ui::PictureSize size, const char* advice) {
  for (const int side : {size.width, size.height}) {
    if (side < ui::min_picture_side || side > ui::largest_picture_side) {
      throw InputError(fmt::format("--size '{}': {} pixels is out of range; each side may have {} to {}{}",
                                   text, side, ui::min_picture_side, ui::largest_picture_side, advice));
    }
  }
}

}  // namespace

ui::PictureSize parse_picture_size(const std::string& text) {
  ui::PictureSize size;
  const char* const end = text.data() + text.size();
  const auto [by, width_error] = std::from_chars(text.data(), end, size.width);
  const bool has_by = width_error == std::errc() && by != end && (*by == 'x' || *by == 'X');
  const auto [rest, height_error] = has_by ? std::from_chars(by + 1, end, size.height)
                                           : std::from_chars_result{by, std::errc::invalid_argument};
  if (height_error != std::errc() || rest != end) {
    throw InputError(
        fmt::format("--size '{}' is not a size; give width and height in pixels, such as 1280x960", text));
  }
  check_sides(text, size, "");
  return size;
}

PageSize parse_page_size(const std::string& text, double dpi) {
  const std::string upright = "-portrait";
  const bool portrait = text.ends_with(upright);
  const auto found = sheets.find(portrait ? text.substr(0, text.size() - upright.size()) : text);
  if (found == sheets.end()) {
    try {
      return {parse_picture_size(text), {}};
    } catch (const InputError& error) {
      const std::string near = nearest_name(text, sheet_names());
      throw InputError(near.empty() ? error.what()
                                    : fmt::format("{}; or did you mean '{}'?", error.what(), near));
    }
  }
  QSizeF paper = QPageSize::size(found->second, QPageSize::Millimeter);
  if (!portrait) {
    paper.transpose();
  }
  constexpr double inch = 25.4;
  PageSize page{{static_cast<int>(std::lround(paper.width() / inch * dpi)),
                 static_cast<int>(std::lround(paper.height() / inch * dpi))},
                paper};
  check_sides(text, page.pixels, "; use a smaller --dpi");
  return page;
}

}  // namespace feedscope
