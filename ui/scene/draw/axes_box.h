#pragma once

#include <string>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/draw/canvas.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// The frame around the path as one projection shows it: grids on the faces behind the path, ticks and labels
/// in mm along three outer edges. Labels keep their distance; an axis seen end on has none.
struct AxesLayout {
  struct Stroke {
    Vec2 from, to;
  };
  struct Label {
    std::string text;
    Vec2 place;
    TextStyle style;
  };

  std::vector<Stroke> grid;
  std::vector<Stroke> frame;  ///< edges of those faces, ticks
  std::vector<Label> labels;
  Vec2 low;   ///< lower left of all there is [pixels]
  Vec2 high;  ///< upper right
};

/// `scale`: size of text and lines, 1 for 96 dots an inch.
AxesLayout lay_out_axes(const SceneFrame& frame, const Projection& projection, double scale);

/// `grid`: with the lines across the faces.
void draw(const AxesLayout& layout, double scale, bool grid, const SceneColours& colours,
          const SceneTexts& texts, Canvas& canvas);

}  // namespace feedscope::ui
