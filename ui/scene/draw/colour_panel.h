#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/scene/draw/captions.h"

namespace feedscope::ui {

inline constexpr double panel_text_pixels = 13;
inline constexpr double panel_margin = 12;

/// What the panel that says what the colours mean needs beside a scene `width` pixels wide.
double colour_panel_width(const Captions& captions, int width, double scale);

/// A limiting cause with its share in the panel.
struct CauseRow {
  std::vector<std::string> lines;
  std::optional<Rgb> colour;  ///< none: how many have no room
};
/// The causes that a room of `width` and `height` holds [pixels], the longest first. Where not all fit, the
/// last row says how many are omitted: "+ 4".
std::vector<CauseRow> fitting_cause_rows(const Captions& captions, double width, double height, double scale);

/// Scale with title, unit and values, or limiting causes with their shares of the time, between two corners
/// of the window; what does not fit is omitted.
/// Least height of what draw_colour_panel() draws [pixels]; 0 where there is nothing to draw.
double min_colour_panel_height(const Captions& captions, double scale);

void draw_colour_panel(Canvas& canvas, const Captions& captions, const Vec2& low, const Vec2& high,
                       double scale);

}  // namespace feedscope::ui
