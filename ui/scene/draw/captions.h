#pragma once

#include <string>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/draw/canvas.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// What the legend names.
struct LegendEntries {
  struct Overlay {
    std::string name;
    Rgb colour{};
  };
  bool programmed = false;
  bool rapid = false;
  bool executed = false;
  bool blend = false;
  bool curve = false;      ///< smooth curves
  bool tool_axis = false;  ///< of a tool that rotary axes turn
  std::vector<Overlay> overlays;
};

/// What is written beside the path.
struct Captions {
  LegendEntries entries;
  ColourKey key;
  Rgb run{};                ///< colour of the run, for Colouring::run
  double exaggeration = 1;  ///< of deviations
  const SceneColours* colours = nullptr;
  const SceneTexts* texts = nullptr;
  bool on_machine = false;   ///< the path is drawn in the coordinates of the machine
  bool transparent = false;  ///< nothing is put behind legend and panel
};

/// The parts of the window: legend above, panel on the right, and the rest for the path.
struct ScreenLayout {
  double width, height;  ///< [pixels]
  double scale;          ///< of text and lines
  double panel_width;
  double legend_height;
  bool cube = true;  ///< false where the colours would have no room above it

  Vec2 low() const { return Vec2::Constant(14 * scale); }  ///< of the part for the path
  Vec2 high() const { return {width - panel_width - 10 * scale, height - legend_height - 8 * scale}; }
};

ScreenLayout screen_layout(int width, int height, double scale, const Captions& captions);

/// Draws legend and panel: what the colours mean, and a bar of round length (in a perspective view true in
/// the middle of the view only, and omitted). `millimetre`: pixels a mm.
void draw_captions(Canvas& canvas, const ScreenLayout& layout, const Captions& captions,
                   const Projection& projection, double millimetre);

}  // namespace feedscope::ui
