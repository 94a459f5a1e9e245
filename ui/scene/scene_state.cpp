#include "ui/scene/scene_state.h"

namespace feedscope::ui {

SceneState scene_state(const PathScene& scene) {
  return {.camera = scene.camera(),
          .colouring = scene.colouring(),
          .exaggeration = scene.exaggeration(),
          .tool = scene.tool(),
          .axes = scene.axes(),
          .actual = scene.actual_shown(),
          .rapids = scene.rapids_shown(),
          .all_rapids = scene.all_rapids_shown(),
          .on_machine = scene.on_machine(),
          .stretch = scene.stretch()};
}

void set_scene_state(PathScene& scene, const SceneState& state) {
  scene.set_on_machine(state.on_machine);
  scene.set_colouring(state.colouring);
  scene.set_exaggeration(state.exaggeration);
  scene.set_tool(state.tool);
  scene.set_axes(state.axes);
  scene.set_actual_shown(state.actual);
  scene.set_rapids_shown(state.rapids);
  scene.set_all_rapids_shown(state.all_rapids);
  scene.set_stretch(state.stretch);
  scene.set_camera(state.camera);
}

SceneState for_any_path(SceneState state) {
  const CameraState any;
  state.camera.focal = any.focal;
  state.camera.height = any.height;
  state.camera.fitted = true;
  return state;
}

}  // namespace feedscope::ui
