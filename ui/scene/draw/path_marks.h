#pragma once

#include <functional>

#include "ui/scene/draw/canvas.h"
#include "ui/scene/sampled_path.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// Returns the place in the window [pixels] of a point [mm].
using PlaceInWindow = std::function<Vec2(const Vec3&)>;

struct MarkStyle {
  double scale;
  const SceneColours& colours;
  const SceneTexts& texts;
  double pixels_per_mm = 1;  ///< at the centre of the view
};

void draw_start_mark(Canvas& canvas, const Vec2& place, double scale, const SceneColours& colours);

/// Draws tool axes along the path, the start of the path, and the zero points of a program with several work
/// offsets, with their names; those in one place together. Missing paths are null.
void draw_path_marks(Canvas& canvas, const SampledPath* programmed, const SampledPath* executed,
                     const PlaceInWindow& place_of, const MarkStyle& style);

}  // namespace feedscope::ui
