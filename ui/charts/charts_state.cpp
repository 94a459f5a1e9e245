#include "ui/charts/charts_state.h"

#include <QJsonArray>
#include <algorithm>

namespace feedscope::ui {

namespace {

const QString path_length_key = QStringLiteral("path_length");
const QString time_key = QStringLiteral("time");

QJsonValue json_of(const std::optional<Interval>& interval) {
  return interval ? QJsonValue(QJsonArray{interval->lower, interval->upper}) : QJsonValue();
}

/// Null means no interval; anything but null or two ascending numbers is ignored.
void read_interval(const QJsonValue& json, std::optional<Interval>& interval) {
  const QJsonArray ends = json.toArray();
  if (json.isNull()) {
    interval.reset();
  } else if (ends.size() == 2 && ends[0].isDouble() && ends[1].isDouble() &&
             ends[0].toDouble() < ends[1].toDouble()) {
    interval = {ends[0].toDouble(), ends[1].toDouble()};
  }
}

void read_keys(const QJsonValue& json, QStringList& keys) {
  if (json.isArray()) {
    keys = json.toVariant().toStringList();
  }
}

}  // namespace

ChartsState for_any_run(ChartsState state) {
  state.time.reset();
  state.hidden.clear();
  state.shown.clear();
  state.values = {};
  state.second_cursor.reset();
  return state;
}

bool is_shown(const CurveSpec& curve, const ChartsState& state) {
  return curve.on_demand ? state.shown.contains(curve.key) : !state.hidden.contains(curve.key);
}

bool is_shown(const ChartSpec& chart, const ChartsState& state) {
  return chart.on_demand ? state.shown_charts.contains(chart.key) : !state.hidden_charts.contains(chart.key);
}

QJsonObject to_json(const ChartsState& state) {
  QJsonArray values;
  for (const auto& interval : state.values) {
    values.append(json_of(interval));
  }
  QJsonObject json{
      {"abscissa", state.abscissa == Abscissa::time ? time_key : path_length_key},
      {"time_s", json_of(state.time)},
      {"values", values},
      {"hidden", QJsonArray::fromStringList(state.hidden)},
      {"other_runs", QJsonArray::fromStringList(state.other_runs)},
      {"causes", state.causes},
      {"second_cursor_s", state.second_cursor ? QJsonValue(*state.second_cursor) : QJsonValue()}};
  if (!state.shown.isEmpty()) {
    json["shown"] = QJsonArray::fromStringList(state.shown);
  }
  if (!state.hidden_charts.isEmpty()) {
    json["hidden_charts"] = QJsonArray::fromStringList(state.hidden_charts);
  }
  if (!state.shown_charts.isEmpty()) {
    json["shown_charts"] = QJsonArray::fromStringList(state.shown_charts);
  }
  return json;
}

void read_json(const QJsonObject& json, ChartsState& state) {
  if (json["abscissa"] == time_key || json["abscissa"] == path_length_key) {
    state.abscissa = json["abscissa"] == time_key ? Abscissa::time : Abscissa::path_length;
  }
  read_interval(json["time_s"], state.time);
  const QJsonArray values = json["values"].toArray();
  // Older versions had fewer charts, and so have their sessions.
  const auto known = std::min(values.size(), static_cast<qsizetype>(state.values.size()));
  for (qsizetype i = 0; i < known; ++i) {
    read_interval(values[i], state.values[static_cast<std::size_t>(i)]);
  }
  read_keys(json["hidden"], state.hidden);
  state.shown.clear();
  read_keys(json["shown"], state.shown);
  state.hidden_charts.clear();
  read_keys(json["hidden_charts"], state.hidden_charts);
  state.shown_charts.clear();
  read_keys(json["shown_charts"], state.shown_charts);
  read_keys(json["other_runs"], state.other_runs);
  state.causes = json["causes"].toBool(state.causes);
  if (json["second_cursor_s"].isDouble()) {
    state.second_cursor = json["second_cursor_s"].toDouble();
  } else if (json["second_cursor_s"].isNull()) {
    state.second_cursor.reset();
  }
}

}  // namespace feedscope::ui
