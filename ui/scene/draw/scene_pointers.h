#pragma once

#include <array>
#include <optional>

#include "ui/scene/draw/path_marks.h"
#include "ui/scene/draw/pointers.h"
#include "ui/scene/path_scene.h"

namespace feedscope::ui {

/// Marks of the mouse in a scene.
struct ScenePointers {
  std::optional<Vec3> hover;  ///< [mm]
  std::optional<SceneDimension> dimension;
  std::optional<std::array<Pixel, 2>> rubber_band;
};

/// `place_of`: in the window; `height`: of the window [px]; `room`: for the box of a dimension.
void draw_scene_pointers(Canvas& canvas, const ScenePointers& pointers, const PlaceInWindow& place_of,
                         int height, const ScreenRectangle& room, double scale, const SceneColours& colours);

}  // namespace feedscope::ui
