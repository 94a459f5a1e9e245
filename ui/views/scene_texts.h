#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/trajectory/trajectory.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// The scene's texts in the language of the window, numbers by its locale.
SceneTexts scene_texts();

/// What the mouse tells of an instant: line, feed and programmed feed, limiting cause, contour error [mm].
QString hover_text(const State& state, double contour_error);

/// From one place of the path to another: distance, its parts, path length and time.
std::vector<std::string> measurement_lines(const State& from, const State& to);

}  // namespace feedscope::ui
