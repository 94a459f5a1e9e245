#pragma once

#include <QJsonObject>

#include "ui/scene/scene_state.h"

namespace feedscope::ui {

QJsonObject to_json(const SceneState& state);
/// Missing or wrong values leave `state` unchanged.
void read_json(const QJsonObject& json, SceneState& state);

}  // namespace feedscope::ui
