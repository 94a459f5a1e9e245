#pragma once

#include <string>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/draw/canvas.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// The frame around the path in one projection: grids on the faces behind the path, ticks and labels in mm
/// along three outer edges. Labels keep their distance; an axis seen end on has none.
struct AxesLayout {
  struct Stroke {
    Vec2 from, to;
  };
  struct Label {
    std::string text;
    Vec2 place;
    TextStyle style;
    ScreenRectangle box;
  };

  std::vector<Stroke> grid;
  std::vector<Stroke> frame;  ///< edges of those faces, ticks
  std::vector<Label> labels;
  std::vector<Vec2> outline;  ///< corners of all parts [pixels]
};

/// `scale`: size of text and lines, 1 for 96 dots per inch.
AxesLayout lay_out_axes(const SceneFrame& frame, const Projection& projection, double scale);

/// Omits labels that the edge of the `window` would cut off.
void draw(const AxesLayout& layout, double scale, const ScreenRectangle& window, const SceneColours& colours,
          const SceneTexts& texts, Canvas& canvas);

}  // namespace feedscope::ui
