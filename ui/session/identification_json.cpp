#include "ui/session/identification_json.h"

#include <QJsonArray>
#include <algorithm>

#include "core/base/error.h"
#include "ui/session/result_json.h"
#include "ui/session/session_json.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {
namespace {

const QString typical_start = QStringLiteral("typical");

/// The row number in a table; none if the value is not a whole number from 0 on.
std::optional<std::size_t> row_of(const QJsonValue& json) {
  constexpr int none = -1;
  const int row = json.toInt(none);
  return row >= 0 ? std::optional(static_cast<std::size_t>(row)) : std::nullopt;
}

// ---- Tables of section times

QJsonObject to_json(const TableState& state, const std::filesystem::path& folder) {
  const std::filesystem::path file = to_path(state.table->name);
  const std::filesystem::path relative = file.lexically_relative(folder);
  QJsonArray times;
  double resolution = 0;
  for (const SectionTime& time : state.table->times) {
    times.append(QJsonObject{{"section", QString::fromStdString(time.section)},
                             {"seconds", time.seconds},
                             {"row", static_cast<double>(time.row)}});
    resolution = time.resolution;
  }
  return {{"file", to_portable_qstring(relative.empty() ? file : relative)},
          {"used", state.used},
          {"resolution_s", resolution},
          {"times", times}};
}

/// Null with a note if a time or the resolution is not above 0.
TableState read_table(const QJsonObject& json, const std::filesystem::path& folder, QStringList& notes) {
  note_unknown(json, {"file", "used", "resolution_s", "times"}, QStringLiteral("\"section_times\""), notes);
  auto table = std::make_shared<SectionTable>();
  table->name = to_qstring((folder / to_path(json["file"].toString())).lexically_normal());
  for (const QJsonValue& time : json["times"].toArray()) {
    const std::size_t row = row_of(time["row"]).value_or(0);
    table->times.push_back({time["section"].toString().toStdString(), time["seconds"].toDouble(),
                            json["resolution_s"].toDouble(), static_cast<std::uint32_t>(row)});
  }
  const bool is_usable = !table->times.empty() && std::ranges::all_of(table->times, [](const auto& time) {
    return time.seconds > 0 && time.resolution > 0;
  });
  if (!is_usable) {
    notes.append(QStringLiteral("section times \"%1\" are omitted: \"seconds\" and \"resolution_s\" must be "
                                "above 0")
                     .arg(json["file"].toString()));
    return {};
  }
  return {std::move(table), json["used"].toBool(true)};
}

// ---- Choices of models and numbers

void add_choice(const FitChoiceState& choice, QJsonObject& json) {
  if (choice.run) {
    json["begin_with_run"] = static_cast<double>(*choice.run);
  }
  if (choice.typical || !choice.machine.isEmpty()) {
    json["begin_with"] = choice.typical ? typical_start : choice.machine;
  }
  if (choice.models) {
    QJsonArray models;
    for (const std::string& id : *choice.models) {
      models.append(QString::fromStdString(id));
    }
    json["models"] = models;
  }
  QJsonObject wanted;
  for (const auto& [key, is_wanted] : choice.wanted) {
    wanted[QString::fromStdString(key)] = is_wanted;
  }
  if (!wanted.isEmpty()) {
    json["fit"] = wanted;
  }
}

FitChoiceState read_choice(const QJsonObject& json) {
  FitChoiceState choice;
  choice.run = row_of(json["begin_with_run"]);
  choice.typical = json["begin_with"] == typical_start;
  choice.machine = choice.typical ? QString() : json["begin_with"].toString();
  if (json["models"].isArray()) {
    choice.models.emplace();
    for (const QJsonValue& id : json["models"].toArray()) {
      choice.models->push_back(id.toString().toStdString());
    }
  }
  const QJsonObject wanted = json["fit"].toObject();
  for (auto entry = wanted.begin(); entry != wanted.end(); ++entry) {
    choice.wanted[entry.key().toStdString()] = entry.value().toBool();
  }
  return choice;
}

}  // namespace

QJsonObject to_json(const IdentificationState& state, const std::filesystem::path& folder,
                    const MachineLibrary& machines) {
  QJsonObject json;
  QJsonArray unused;
  for (const std::size_t row : state.unused_traces) {
    unused.append(static_cast<double>(row));
  }
  if (!unused.isEmpty()) {
    json["unused_traces"] = unused;
  }
  QJsonArray tables;
  for (const TableState& table : state.tables) {
    tables.append(to_json(table, folder));
  }
  if (!tables.isEmpty()) {
    json["section_times"] = tables;
  }
  add_choice(state.choice, json);
  if (state.result.outcome != nullptr) {
    json["result"] = to_json(state.result, machines);
  }
  return json;
}

IdentificationState read_identification(const QJsonObject& json, const std::filesystem::path& folder,
                                        const MachineLibrary& machines, QStringList& notes) {
  note_unknown(json,
               {"unused_traces", "section_times", "begin_with_run", "begin_with", "models", "fit", "result"},
               QStringLiteral("\"identification\""), notes);
  IdentificationState state;
  for (const QJsonValue& row : json["unused_traces"].toArray()) {
    if (const auto number = row_of(row)) {
      state.unused_traces.push_back(*number);
    }
  }
  for (const QJsonValue& table : json["section_times"].toArray()) {
    if (TableState read = read_table(table.toObject(), folder, notes); read.table != nullptr) {
      state.tables.push_back(std::move(read));
    }
  }
  state.choice = read_choice(json);
  if (json.contains("result")) {
    try {
      state.result = read_result(json["result"].toObject(), machines, notes);
    } catch (const InputError& error) {
      notes.append(QStringLiteral("what was identified is omitted: %1").arg(QString::fromUtf8(error.what())));
    }
  }
  return state;
}

}  // namespace feedscope::ui
