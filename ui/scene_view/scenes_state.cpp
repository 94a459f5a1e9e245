#include "ui/scene_view/scenes_state.h"

#include <array>
#include <cmath>

namespace feedscope::ui {
namespace {

constexpr std::array mode_keys{"one", "side_by_side", "split"};  // in the order of ScenesMode

void read_row(const QJsonValue& json, std::optional<std::size_t>& row) {
  const double number = json.toDouble(-1);
  if (number >= 0 && number < 1e6 && number == std::floor(number)) {
    row = static_cast<std::size_t>(number);
  }
}

}  // namespace

QJsonObject to_json(const ScenesState& state) {
  QJsonObject json{{"mode", mode_keys.at(static_cast<std::size_t>(state.mode))}, {"split", state.split}};
  if (state.other) {
    json["other_run"] = static_cast<int>(*state.other);
  }
  if (state.reference) {
    json["reference_run"] = static_cast<int>(*state.reference);
  }
  return json;
}

void read_json(const QJsonObject& json, ScenesState& state) {
  for (std::size_t mode = 0; mode < mode_keys.size(); ++mode) {
    if (json["mode"] == QLatin1String(mode_keys[mode])) {
      state.mode = static_cast<ScenesMode>(mode);
    }
  }
  const double split = json["split"].toDouble(-1);
  if (split >= 0 && split <= 1) {
    state.split = split;
  }
  read_row(json["other_run"], state.other);
  read_row(json["reference_run"], state.reference);
}

}  // namespace feedscope::ui
