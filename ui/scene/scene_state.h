#pragma once

#include "ui/scene/path_scene.h"

namespace feedscope::ui {

/// What a user has set in the 3D view, as sessions and the next start get it back.
struct SceneState {
  CameraState camera = {};
  Colouring colouring = Colouring::feed;
  double exaggeration = 1;  ///< of deviations from the programmed path, 1 to 1000
  ToolShape tool = {};
  bool axes = false;        ///< a box with the size of the path
  bool actual = true;       ///< the path that the axes run is drawn
  bool rapids = true;       ///< are drawn where they cover little of the picture
  bool all_rapids = false;  ///< where they cover much of it, too
  bool on_machine = false;  ///< in the coordinates of the machine, where rotary axes turn
  StretchChoice stretch = {};

  bool operator==(const SceneState&) const = default;
};

SceneState scene_state(const PathScene& scene);
void set_scene_state(PathScene& scene, const SceneState& state);

/// The same without what belongs to one path: the view is turned as before, and fitted.
SceneState for_any_path(SceneState state);

}  // namespace feedscope::ui
