#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/analysis/contour/actual_path.h"
#include "core/analysis/load/load_sample.h"
#include "core/trajectory/trajectory.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// The scene's texts in the language of the window, numbers by its locale.
SceneTexts scene_texts();

/// Hover text for a time: line, feed and programmed feed, limiting cause, contour error [mm].
QString hover_text(const State& state, double contour_error);

/// Hover text on the axes at a time: their contour error and following errors.
QString drives_text(const ActualSample& actual);
/// The cutting load at a time; empty without one.
QString load_text(const LoadSample& load);

/// A place of a run compared with the same place of another run of the program.
struct PlaceComparison {
  QString reference;          ///< name of the other run
  double time = 0;            ///< of the run at the place [s]
  double lost = 0;            ///< against the other run, up to the place [s]
  double pace = 0;            ///< time lost here [s/mm]
  double distance = 0;        ///< from the other path [mm]
  double feed = 0;            ///< [mm/s]
  double reference_feed = 0;  ///< of the other [mm/s]
};
/// The comparison in words.
QString comparison_text(const PlaceComparison& place);

/// From one place of the path to another: distance, its parts, path length and time.
std::vector<std::string> measurement_lines(const State& from, const State& to);

}  // namespace feedscope::ui
