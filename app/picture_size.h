#pragma once

#include <map>
#include <optional>
#include <string>

#include <QSizeF>

#include "ui/scene/picture.h"

namespace feedscope {

/// Views of --camera.
inline const std::map<std::string, ui::StandardView> camera_views{{"iso", ui::StandardView::iso},
                                                                  {"top", ui::StandardView::top},
                                                                  {"front", ui::StandardView::front},
                                                                  {"right", ui::StandardView::right}};

/// Reads a --size, "800x600". Throws InputError for another form, and if a side is out of bounds.
ui::PictureSize parse_picture_size(const std::string& text);

/// A --size that may be a sheet of paper.
struct PageSize {
  ui::PictureSize pixels;
  std::optional<QSizeF> paper;  ///< [mm]; none: the size was given in pixels
};

/// Reads "800x600", or a sheet: "A4" landscape, "A4-portrait"; A2 to A6, Letter. `dpi`: pixels per inch of
/// sheets. Throws InputError for another form, and if a side is out of bounds.
PageSize parse_page_size(const std::string& text, double dpi);

}  // namespace feedscope
