#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/scene/camera/scene_camera.h"
#include "ui/scene/draw/canvas.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// Draws a line with ends between two places of the window and a text box next to it, kept within `room`; a
/// ring if there is no second place yet.
void draw_dimension(Canvas& canvas, const Vec2& from, const std::optional<Vec2>& to,
                    const std::vector<std::string>& lines, const ScreenRectangle& room, double scale,
                    const SceneColours& colours);

/// Draws a ring around the place of the path under the mouse.
void draw_ring(Canvas& canvas, const Vec2& place, double scale, const SceneColours& colours);

void draw_rubber_band(Canvas& canvas, const Vec2& corner, const Vec2& opposite, double scale,
                      const SceneColours& colours);

}  // namespace feedscope::ui
