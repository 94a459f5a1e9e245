#include "ui/scene_view/scene_json.h"

#include <QJsonArray>
#include <cmath>

namespace feedscope::ui {

namespace {

constexpr std::array tool_keys{"none", "marker", "flat", "ball", "bull"};  // in the order of ToolKind
constexpr std::array stretch_keys{"whole", "charts", "to_cursor"};         // of PathStretch

QString key_of(Colouring colouring) {
  return QString::fromStdString(colouring_key(colouring));
}

void read_number(const QJsonValue& json, double& number) {
  number = json.toDouble(number);
}

void read_positive(const QJsonValue& json, double& number) {
  if (json.toDouble() > 0) {
    number = json.toDouble();
  }
}

/// Rounds away the last digits, which differ when a fit is repeated.
double kept(double length) {
  constexpr double nanometre = 1e-6;  // [mm]
  return std::round(length / nanometre) * nanometre;
}

QJsonObject json_of(const CameraState& camera) {
  return {{"focal_mm",
           camera.fitted ? QJsonArray{kept(camera.focal.x()), kept(camera.focal.y()), kept(camera.focal.z())}
                         : QJsonArray{camera.focal.x(), camera.focal.y(), camera.focal.z()}},
          {"azimuth_rad", camera.azimuth},
          {"elevation_rad", camera.elevation},
          {"height_mm", camera.fitted ? kept(camera.height) : camera.height},
          {"perspective", camera.perspective},
          {"fitted", camera.fitted}};
}

void read_camera(const QJsonObject& json, CameraState& camera) {
  const QJsonArray focal = json["focal_mm"].toArray();
  if (focal.size() == 3 && focal[0].isDouble() && focal[1].isDouble() && focal[2].isDouble()) {
    camera.focal = Vec3(focal[0].toDouble(), focal[1].toDouble(), focal[2].toDouble());
  }
  read_number(json["azimuth_rad"], camera.azimuth);
  read_number(json["elevation_rad"], camera.elevation);
  read_positive(json["height_mm"], camera.height);
  camera.perspective = json["perspective"].toBool(camera.perspective);
  camera.fitted = json["fitted"].toBool(camera.fitted);
}

void read_tool(const QJsonObject& json, ToolShape& tool) {
  for (std::size_t kind = 0; kind < tool_keys.size(); ++kind) {
    if (json["kind"] == QLatin1String(tool_keys[kind])) {
      tool.kind = static_cast<ToolKind>(kind);
    }
  }
  read_positive(json["diameter_mm"], tool.diameter);
  read_positive(json["corner_radius_mm"], tool.corner_radius);
}

}  // namespace

QJsonObject to_json(const SceneState& state) {
  return {{"camera", json_of(state.camera)},
          {"colouring", key_of(state.colouring)},
          {"exaggeration", state.exaggeration},
          {"tool", QJsonObject{{"kind", tool_keys.at(static_cast<std::size_t>(state.tool.kind))},
                               {"diameter_mm", state.tool.diameter},
                               {"corner_radius_mm", state.tool.corner_radius}}},
          {"grid", state.axes},
          {"actual_path", state.actual},
          {"rapids", state.rapids},
          {"all_rapids", state.all_rapids},
          {"machine_axes", state.on_machine},
          {"stretch", stretch_keys.at(static_cast<std::size_t>(state.stretch.stretch))},
          {"rest_hidden", state.stretch.rest_hidden}};
}

void read_json(const QJsonObject& json, SceneState& state) {
  read_camera(json["camera"].toObject(), state.camera);
  for (const Colouring colouring : all_colourings()) {
    if (json["colouring"] == key_of(colouring)) {
      state.colouring = colouring;
    }
  }
  read_positive(json["exaggeration"], state.exaggeration);
  read_tool(json["tool"].toObject(), state.tool);
  state.axes = json["grid"].toBool(state.axes);
  state.actual = json["actual_path"].toBool(state.actual);
  state.rapids = json["rapids"].toBool(state.rapids);
  state.all_rapids = json["all_rapids"].toBool(state.all_rapids);
  state.on_machine = json["machine_axes"].toBool(state.on_machine);
  for (std::size_t stretch = 0; stretch < stretch_keys.size(); ++stretch) {
    if (json["stretch"] == QLatin1String(stretch_keys[stretch])) {
      state.stretch.stretch = static_cast<PathStretch>(stretch);
    }
  }
  state.stretch.rest_hidden = json["rest_hidden"].toBool(state.stretch.rest_hidden);
}

}  // namespace feedscope::ui
