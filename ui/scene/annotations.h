#pragma once

#include "ui/scene/canvas.h"
#include "ui/scene/projection.h"

namespace feedscope::ui {

/// What the legend names.
struct LegendEntries {
  bool programmed = false;
  bool rapid = false;
  bool executed = false;
  bool blend = false;
};

/// The parts of the window: legend above, panel on the right, and the rest for the path.
struct ScreenLayout {
  double width, height;  ///< [pixels]
  double scale;          ///< of text and lines
  double panel_width;
  double legend_height;

  Vec2 low() const { return Vec2::Constant(14 * scale); }  ///< of the part for the path
  Vec2 high() const { return {width - panel_width - 10 * scale, height - legend_height - 8 * scale}; }
};

ScreenLayout screen_layout(int width, int height, double scale, const LegendEntries& entries,
                           bool colour_bar);

/// Draws legend and panel: colour bar of the feed from 0 to `top_feed` [mm/s] (none if 0), axes cross, and a
/// bar of round length. `millimetre`: pixels a mm.
void draw_annotations(Canvas& canvas, const ScreenLayout& layout, const LegendEntries& entries,
                      const Projection& projection, double millimetre, double top_feed);

/// Where the path starts.
void draw_start_marker(Canvas& canvas, const Vec2& place, double scale);

}  // namespace feedscope::ui
