#pragma once

#include "ui/scene/path_scene.h"

namespace feedscope::ui {

/// The user's settings of the 3D view, restored by sessions and the next start.
struct SceneState {
  CameraState camera = {};
  Colouring colouring = Colouring::feed;
  double exaggeration = 1;  ///< of deviations from the programmed path, 1 to 1000
  ToolShape tool = {};
  bool axes = false;        ///< whether to draw a box with the size of the path
  bool actual = true;       ///< whether to draw the actual path
  bool rapids = true;       ///< whether to draw them where they cover little of the picture
  bool all_rapids = false;  ///< also where they cover much of it
  bool on_machine = false;  ///< in the coordinates of the machine, if rotary axes turn
  StretchChoice stretch = {};

  bool operator==(const SceneState&) const = default;
};

SceneState scene_state(const PathScene& scene);
void set_scene_state(PathScene& scene, const SceneState& state);

/// `state` without the parts that belong to one path: the view keeps its direction, and is fitted.
SceneState for_any_path(SceneState state);

}  // namespace feedscope::ui
