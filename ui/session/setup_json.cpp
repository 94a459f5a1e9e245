#include "ui/session/setup_json.h"

#include <QJsonArray>
#include <algorithm>

#include "core/base/error.h"
#include "ui/session/session_json.h"

namespace feedscope::ui {
namespace {

QJsonValue to_json(const SettingValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? QJsonValue(*number)
                           : QJsonValue(QString::fromStdString(std::get<std::string>(value)));
}

bool is_shipped(const Machine& machine, const MachineLibrary& machines) {
  return std::ranges::find(machines.ids(), machine.id) != machines.ids().end() &&
         machines.load(machine.id) == machine;
}

/// Differences from the machine's file: edits, and settings of a command line.
QJsonObject changes_of(const SetupState& state) {
  QJsonObject changes;
  const Settings plain = complete_settings(*state.file().model, state.file().machine);
  for (const auto& [key, value] : state.file().settings.values()) {
    if (!plain.has(key) || plain.values().at(key) != value) {
      changes[QString::fromStdString(key)] = to_json(value);
    }
  }
  for (const auto& [key, value] : state.edits()) {
    changes[QString::fromStdString(key)] = to_json(value);
  }
  return changes;
}

Machine read_machine_of(const QJsonObject& json, const MachineLibrary& machines, const QString& place) {
  if (!json.contains("machine_file")) {
    return machines.load(json["machine"].toString().toStdString());
  }
  const QString text = json["machine_file"].toVariant().toStringList().join('\n');
  return parse_machine(text.toStdString(), (place + QStringLiteral(", machine_file")).toStdString(),
                       all_model_settings());
}

SettingValue setting_of(const QJsonValue& json) {
  return json.isString() ? SettingValue(json.toString().toStdString()) : SettingValue(json.toDouble());
}

}  // namespace

QJsonObject to_json(const SetupState& state, const MachineLibrary& machines) {
  const Machine& machine = state.file().machine;
  QJsonObject json{{"model", QString::fromStdString(state.file().model->info().id)},
                   {"set", changes_of(state)}};
  if (is_shipped(machine, machines)) {
    json["machine"] = QString::fromStdString(machine.id);
  } else {
    json["machine_file"] =
        QJsonArray::fromStringList(QString::fromStdString(write_machine(machine)).split('\n'));
  }
  return json;
}

SetupState read_setup(const QJsonObject& json, const QString& place, const MachineLibrary& machines) {
  try {
    Setup file;
    file.machine = read_machine_of(json, machines, place);
    file.model =
        &find_model(json["model"].toString(QString::fromStdString(file.machine.model)).toStdString());
    file.settings = complete_settings(*file.model, file.machine);
    SetupState state(std::move(file));
    const QJsonObject set = json["set"].toObject();
    for (auto entry = set.begin(); entry != set.end(); ++entry) {
      state.set(entry.key().toStdString(), setting_of(entry.value()));
    }
    return state;
  } catch (const InputError& error) {
    throw input_error(QStringLiteral("%1: %2").arg(place, QString::fromUtf8(error.what())));
  }
}

}  // namespace feedscope::ui
