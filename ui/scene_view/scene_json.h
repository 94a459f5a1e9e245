#pragma once

#include <QJsonObject>

#include "ui/scene/scene_state.h"

namespace feedscope::ui {

QJsonObject to_json(const SceneState& state);
/// What is missing or wrong stays as it is in `state`.
void read_json(const QJsonObject& json, SceneState& state);

}  // namespace feedscope::ui
