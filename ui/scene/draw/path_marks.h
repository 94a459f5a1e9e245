#pragma once

#include <functional>

#include "ui/scene/draw/canvas.h"
#include "ui/scene/sampled_path.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// Gives the place in the window [pixels] of a point [mm].
using PlaceInWindow = std::function<Vec2(const Vec3&)>;

struct MarkStyle {
  double scale;
  const SceneColours& colours;
  const SceneTexts& texts;
  double pixels_per_mm = 1;  ///< where the view has its middle
};

/// Where the tool points along the path, where the path starts, and the zero points of a program that uses
/// several work offsets, with their names; those in one place together. Paths that there are not are null.
void draw_path_marks(Canvas& canvas, const SampledPath* programmed, const SampledPath* executed,
                     const PlaceInWindow& place_of, const MarkStyle& style);

}  // namespace feedscope::ui
