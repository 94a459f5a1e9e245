#include "ui/circular/circular_state.h"

#include <QJsonArray>

#include "core/base/error.h"

namespace feedscope::ui {

namespace {

QJsonArray json_of(const std::vector<double>& numbers) {
  QJsonArray array;
  for (const double number : numbers) {
    array.append(number);
  }
  return array;
}

void read_numbers(const QJsonValue& json, std::vector<double>& numbers) {
  std::vector<double> read;
  for (const QJsonValue& value : json.toArray()) {
    if (!value.isDouble() || !(value.toDouble() > 0)) {
      return;
    }
    read.push_back(value.toDouble());
  }
  if (!read.empty() && read.size() <= max_circular_tests) {
    numbers = std::move(read);
  }
}

}  // namespace

QJsonObject to_json(const CircularState& state) {
  return {{"source", state.of_program ? "program" : "test"},
          {"radii_mm", json_of(state.radii)},
          {"feeds_mm_min", json_of(state.feeds)},
          {"plane", QString::fromLatin1(info_of(state.plane).name.data())},
          {"entry_arc", state.entry_arc},
          {"entry_radius_mm", state.entry_radius}};
}

void read_json(const QJsonObject& json, CircularState& state) {
  if (json["source"] == QStringLiteral("test") || json["source"] == QStringLiteral("program")) {
    state.of_program = json["source"] == QStringLiteral("program");
  }
  read_numbers(json["radii_mm"], state.radii);
  read_numbers(json["feeds_mm_min"], state.feeds);
  try {
    state.plane = parse_plane(json["plane"].toString().toStdString());
  } catch (const InputError&) {
    // unchanged
  }
  state.entry_arc = json["entry_arc"].toBool(state.entry_arc);
  if (const double radius = json["entry_radius_mm"].toDouble(); radius > 0) {
    state.entry_radius = radius;
  }
}

}  // namespace feedscope::ui
