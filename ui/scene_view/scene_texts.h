#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/analysis/actual_path.h"
#include "core/analysis/load/load_sample.h"
#include "core/trajectory/trajectory.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// The scene's texts in the language of the window, numbers by its locale.
SceneTexts scene_texts();

/// What the mouse tells of an instant: line, feed and programmed feed, limiting cause, contour error [mm].
QString hover_text(const State& state, double contour_error);

/// What the mouse tells of the axes at an instant: their contour error and following errors.
QString drives_text(const ActualSample& actual);
/// The cutting load at an instant; empty where there is none.
QString load_text(const LoadSample& load);

/// A place of a run beside the same place of another run of the program.
struct PlaceComparison {
  QString reference;          ///< name of the other run
  double time = 0;            ///< when the run is there [s]
  double lost = 0;            ///< of that against the other [s]
  double pace = 0;            ///< lost here [s/mm]
  double distance = 0;        ///< from the other path [mm]
  double feed = 0;            ///< [mm/s]
  double reference_feed = 0;  ///< of the other [mm/s]
};
/// The same in words.
QString comparison_text(const PlaceComparison& place);

/// From one place of the path to another: distance, its parts, path length and time.
std::vector<std::string> measurement_lines(const State& from, const State& to);

}  // namespace feedscope::ui
