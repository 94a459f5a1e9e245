#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/scene/path/path_layers.h"

namespace feedscope::ui {

/// The paths that a scene shows; each may be null.
struct ScenePaths {
  std::shared_ptr<const SampledPath> programmed;
  std::shared_ptr<const SampledPath> executed_samples;
  std::shared_ptr<const Trajectory> trajectory;
  std::vector<OverlayRun> overlays;
  bool actual_shown = true;  ///< what the axes run, where the executed path has it

  /// At an instant of the executed path [s]; up where no rotary axis turns, or nowhere on the path.
  Vec3 tool_direction(const std::optional<double>& time) const {
    const bool turns =
        time && trajectory != nullptr && executed_samples != nullptr && executed_samples->rotary != nullptr;
    return turns ? executed_samples->rotary->tool_direction(trajectory->state(*time)) : Vec3(Vec3::UnitZ());
  }

  /// Other runs, and what the axes run.
  std::vector<OverlayRun> shown_overlays(const SceneColours& colours, const SceneTexts& texts) const {
    std::vector<OverlayRun> shown = overlays;
    if (actual_shown && executed_samples != nullptr && executed_samples->actual != nullptr) {
      shown.push_back({executed_samples->actual, colours.actual, texts.actual});
    }
    return shown;
  }
};

}  // namespace feedscope::ui
