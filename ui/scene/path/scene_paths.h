#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/scene/path/path_layers.h"

namespace feedscope::ui {

/// The paths of a scene; each may be null.
struct ScenePaths {
  std::shared_ptr<const SampledPath> programmed;
  std::shared_ptr<const SampledPath> executed_samples;
  std::shared_ptr<const Trajectory> trajectory;
  std::vector<OverlayRun> overlays;
  bool actual_shown = true;    ///< actual path, if the executed path has one
  bool machine_asked = false;  ///< at the machine's X, Y and Z, if the executed path has them

  /// Whether everything is drawn in the coordinates of the machine.
  bool on_machine() const {
    return machine_asked && trajectory != nullptr && executed_samples != nullptr &&
           executed_samples->on_machine != nullptr;
  }
  /// The programmed path does not exist in coordinates of the machine.
  std::shared_ptr<const SampledPath> shown_programmed() const { return on_machine() ? nullptr : programmed; }
  std::shared_ptr<const SampledPath> shown_executed() const {
    return on_machine() ? executed_samples->on_machine : executed_samples;
  }
  /// The tip, or X, Y and Z of the machine, at a time of the executed path [s].
  Vec3 place_at(double time) const {
    const State state = trajectory->state(time);
    return on_machine() ? executed_samples->rotary->slides(state) : state.position;
  }

  /// Direction at a time of the executed path [s]; upwards if no rotary axis turns, or without a time.
  Vec3 tool_direction(const std::optional<double>& time) const {
    const bool turns =
        time && trajectory != nullptr && executed_samples != nullptr && executed_samples->rotary != nullptr;
    if (!turns) {
      return Vec3::UnitZ();
    }
    const RotaryCourse& course = *executed_samples->rotary;
    const State state = trajectory->state(*time);
    return on_machine() ? course.tool_on_machine(state) : course.tool_direction(state);
  }

  /// Other runs, and the actual path; in coordinates of the machine, the runs that have them.
  std::vector<OverlayRun> shown_overlays(const SceneColours& colours, const SceneTexts& texts) const {
    std::vector<OverlayRun> shown = overlays;
    if (on_machine()) {
      std::erase_if(shown, [](const OverlayRun& run) { return run.samples->on_machine == nullptr; });
      for (OverlayRun& run : shown) {
        run.samples = run.samples->on_machine;
      }
      return shown;
    }
    if (actual_shown && executed_samples != nullptr && executed_samples->actual != nullptr) {
      shown.push_back({executed_samples->actual, colours.actual, texts.actual});
    }
    return shown;
  }
};

}  // namespace feedscope::ui
