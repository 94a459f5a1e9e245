#pragma once

#include "ui/scene/draw/captions.h"

namespace feedscope::ui {

inline constexpr double panel_text_pixels = 13;
inline constexpr double panel_margin = 12;

/// What the panel that says what the colours mean needs beside a scene `width` pixels wide.
double colour_panel_width(const Captions& captions, int width, double scale);

/// Scale with title, unit and values, or limiting causes with their shares of the time, between two corners
/// of the window; what does not fit is omitted.
/// Least height of what draw_colour_panel() draws [pixels]; 0 where there is nothing to draw.
double min_colour_panel_height(const Captions& captions, double scale);

void draw_colour_panel(Canvas& canvas, const Captions& captions, const Vec2& low, const Vec2& high,
                       double scale);

}  // namespace feedscope::ui
