#pragma once

#include "ui/scene/draw/path_marks.h"

namespace feedscope::ui {

/// Draws one tool axis from the tip to its end. `scale`: of its line.
void draw_tool_axis(Canvas& canvas, const Vec2& from, const Vec2& to, double scale,
                    const SceneColours& colours);

/// Draws a short stroke from the tip along the tool for some of path.tool_axes, of one length on the screen
/// apart from the view's angle: at most one in each square of half a stroke's width.
void draw_tool_axes(Canvas& canvas, const SampledPath& path, const PlaceInWindow& place_of,
                    const MarkStyle& style);

}  // namespace feedscope::ui
