#include "ui/session/result_json.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>

#include "ui/session/session_json.h"
#include "ui/session/setup_json.h"

namespace feedscope::ui {
namespace {

constexpr std::size_t most_stretches = 200;
const QString trace_kind = QStringLiteral("trace");
const QString table_kind = QStringLiteral("section_times");

QString as_text(const std::string& text) {
  return QString::fromStdString(text);
}

/// A number; 0 for a missing key. Throws InputError for any other value, such as null, which must not count
/// as 0.
double number_of(const QJsonObject& json, QLatin1String key, const QString& place) {
  const QJsonValue value = json[key];
  if (!value.isUndefined() && !value.isDouble()) {
    throw input_error(QStringLiteral("%1: \"%2\" is not a number").arg(place, key));
  }
  return value.toDouble();
}

/// A count or row; 0 for an invalid one.
std::size_t count_of(const QJsonValue& json) {
  constexpr double most = 1e15;  // exact in a double
  const double number = json.toDouble();
  return number >= 0 && number <= most ? static_cast<std::size_t>(number) : 0;
}

// ---- Recordings

QJsonObject to_json(const UsedRecording& recording) {
  return {{"name", recording.name},
          {"kind", recording.is_table ? table_kind : trace_kind},
          {"size", static_cast<double>(recording.size)},
          {"seconds", recording.seconds},
          {"sum", recording.sum}};
}

UsedRecording read_recording(const QJsonObject& json, const QString& place, QStringList& notes) {
  note_unknown(json, {"name", "kind", "size", "seconds", "sum"}, place, notes);
  return {json["name"].toString(), json["kind"] == table_kind, count_of(json["size"]),
          number_of(json, QLatin1String("seconds"), place), number_of(json, QLatin1String("sum"), place)};
}

// ---- Agreement of a model with a recording

/// Adds the times of the cells, grouped if there are many.
void add_stretches(const std::vector<AgreementCell>& cells, QJsonObject& json) {
  const std::size_t together = (cells.size() + most_stretches - 1) / most_stretches;
  QJsonArray recorded;
  QJsonArray simulated;
  for (std::size_t i = 0; i < cells.size(); i += together) {
    double recorded_time = 0;
    double simulated_time = 0;
    for (std::size_t k = i; k < std::min(i + together, cells.size()); ++k) {
      recorded_time += cells[k].measured_time;
      simulated_time += cells[k].simulated_time;
    }
    recorded.append(recorded_time);
    simulated.append(simulated_time);
  }
  json["stretches_recorded_s"] = recorded;
  json["stretches_simulated_s"] = simulated;
}

QJsonObject to_json(const Agreement& agreement, const std::vector<SectionAgreement>& sections) {
  QJsonObject json{{"measured_s", agreement.measured_time},
                   {"cycle_time_s", agreement.simulated_time},
                   {"feed_rms_mm_s", agreement.feed_rms},
                   {"distance_mm", agreement.distance},
                   {"simulated_distance_mm", agreement.simulated_distance}};
  if (!agreement.cells.empty()) {
    add_stretches(agreement.cells, json);
  }
  if (!sections.empty()) {
    QJsonArray rows;
    for (const SectionAgreement& one : sections) {
      rows.append(QJsonObject{{"section", as_text(one.section)},
                              {"measured_s", one.measured_time},
                              {"simulated_s", one.simulated_time}});
    }
    json["sections"] = rows;
  }
  return json;
}

Agreement read_agreement(const QJsonObject& json, const QString& place, QStringList& notes) {
  note_unknown(json,
               {"measured_s", "cycle_time_s", "feed_rms_mm_s", "distance_mm", "simulated_distance_mm",
                "stretches_recorded_s", "stretches_simulated_s", "sections"},
               place, notes);
  Agreement agreement;
  agreement.measured_time = number_of(json, QLatin1String("measured_s"), place);
  agreement.simulated_time = number_of(json, QLatin1String("cycle_time_s"), place);
  agreement.feed_rms = number_of(json, QLatin1String("feed_rms_mm_s"), place);
  agreement.distance = number_of(json, QLatin1String("distance_mm"), place);
  agreement.simulated_distance = number_of(json, QLatin1String("simulated_distance_mm"), place);
  const QJsonArray recorded = json["stretches_recorded_s"].toArray();
  const QJsonArray simulated = json["stretches_simulated_s"].toArray();
  for (qsizetype i = 0; i < std::min(recorded.size(), simulated.size()); ++i) {
    if (!recorded[i].isDouble() || !simulated[i].isDouble()) {
      throw input_error(QStringLiteral("%1: a time of \"stretches_recorded_s\" or \"stretches_simulated_s\" "
                                       "is not a number")
                            .arg(place));
    }
    agreement.cells.push_back({0, 0, recorded[i].toDouble(), simulated[i].toDouble()});
  }
  return agreement;
}

std::vector<SectionAgreement> read_sections(const QJsonArray& json, const QString& place) {
  std::vector<SectionAgreement> sections;
  for (const QJsonValue& value : json) {
    const QJsonObject one = value.toObject();
    sections.push_back({one["section"].toString().toStdString(),
                        number_of(one, QLatin1String("measured_s"), place),
                        number_of(one, QLatin1String("simulated_s"), place)});
  }
  return sections;
}

// ---- Numbers

QJsonObject to_json(const IdentifiedParameter& one) {
  QJsonObject json{{"key", as_text(one.parameter.key)},
                   {"unit", as_text(one.parameter.unit)},
                   {"start", one.start},
                   {"value", one.value},
                   {"told", one.told}};
  if (one.told) {
    json["uncertainty"] = one.uncertainty;
  } else {
    json["reason"] = as_text(one.reason);
    json["told_by"] = as_text(one.told_by);
  }
  if (one.at_least) {
    json["at_least"] = *one.at_least;
  }
  return json;
}

IdentifiedParameter read_parameter(const QJsonObject& json, const QString& place, QStringList& notes) {
  note_unknown(json,
               {"key", "unit", "start", "value", "told", "uncertainty", "reason", "told_by", "at_least"},
               place, notes);
  IdentifiedParameter one;
  one.parameter.key = json["key"].toString().toStdString();
  one.parameter.unit = json["unit"].toString().toStdString();
  one.start = number_of(json, QLatin1String("start"), place);
  one.value = number_of(json, QLatin1String("value"), place);
  one.told = json["told"].toBool();
  one.uncertainty = number_of(json, QLatin1String("uncertainty"), place);
  one.reason = json["reason"].toString().toStdString();
  one.told_by = json["told_by"].toString().toStdString();
  if (json["at_least"].isDouble()) {
    one.at_least = number_of(json, QLatin1String("at_least"), place);
  }
  return one;
}

// ---- Drives

QJsonObject to_json(const DriveFit& drive) {
  return {{"axis", QString(QLatin1Char(drive.axis))},
          {"explains", drive.explains},
          {"samples", static_cast<double>(drive.samples)},
          {"following_error_mm", drive.following_error},
          {"left_mm", drive.left},
          {"delay_s", drive.delay}};
}

/// Reads a drive, whose numbers are among those of the model. Throws InputError unless it is of a linear
/// axis.
DriveFit read_drive(const QJsonObject& json, const QString& place, QStringList& notes) {
  note_unknown(json, {"axis", "explains", "samples", "following_error_mm", "left_mm", "delay_s"}, place,
               notes);
  const QString axis = json["axis"].toString();
  if (axis.size() != 1 || !QStringLiteral("XYZ").contains(axis)) {
    throw input_error(QStringLiteral("%1: \"axis\" is \"%2\"; it must be X, Y or Z").arg(place, axis));
  }
  DriveFit drive;
  drive.axis = axis.front().toLatin1();
  drive.explains = json["explains"].toBool();
  drive.samples = count_of(json["samples"]);
  drive.following_error = number_of(json, QLatin1String("following_error_mm"), place);
  drive.left = number_of(json, QLatin1String("left_mm"), place);
  drive.delay = number_of(json, QLatin1String("delay_s"), place);
  return drive;
}

// ---- Models

QJsonObject to_json(const Identification& found, const MachineLibrary& machines) {
  QJsonObject json = to_json(SetupState(found.setup), machines);
  QJsonArray parameters;
  for (const IdentifiedParameter& one : found.parameters) {
    parameters.append(to_json(one));
  }
  QJsonArray agreements;
  for (std::size_t i = 0; i < found.agreements.size(); ++i) {
    agreements.append(to_json(found.agreements[i], found.sections[i]));
  }
  json["explains"] = found.explains;
  json["residual"] = found.residual;
  json["feed_error"] = found.feed_error;
  json["simulations"] = static_cast<double>(found.simulations);
  json["parameters"] = parameters;
  if (!found.drives.empty()) {
    QJsonArray drives;
    for (const DriveFit& drive : found.drives) {
      drives.append(to_json(drive));
    }
    json["drives"] = drives;
  }
  json["agreements"] = agreements;
  return json;
}

Identification read_model(const QJsonObject& json, const QString& place, std::size_t recordings,
                          const MachineLibrary& machines, QStringList& notes) {
  note_unknown(json,
               {"machine", "machine_file", "model", "set", "explains", "residual", "feed_error",
                "simulations", "parameters", "drives", "agreements"},
               place, notes);
  Identification found;
  found.setup = read_setup(json, place, machines).setup();
  found.explains = json["explains"].toBool();
  found.residual = number_of(json, QLatin1String("residual"), place);
  found.feed_error = number_of(json, QLatin1String("feed_error"), place);
  found.simulations = count_of(json["simulations"]);
  for (const QJsonValue& one : json["parameters"].toArray()) {
    found.parameters.push_back(
        read_parameter(one.toObject(), place + QStringLiteral(", \"parameters\""), notes));
  }
  for (const QJsonValue& one : json["drives"].toArray()) {
    found.drives.push_back(read_drive(one.toObject(), place + QStringLiteral(", \"drives\""), notes));
  }
  const QJsonArray agreements = json["agreements"].toArray();
  if (static_cast<std::size_t>(agreements.size()) != recordings) {
    throw input_error(QStringLiteral("%1 has %2 \"agreements\" for %3 recordings")
                          .arg(place)
                          .arg(agreements.size())
                          .arg(recordings));
  }
  for (const QJsonValue& one : agreements) {
    found.agreements.push_back(
        read_agreement(one.toObject(), place + QStringLiteral(", \"agreements\""), notes));
    found.sections.push_back(read_sections(one["sections"].toArray(), place));
  }
  return found;
}

}  // namespace

QJsonObject to_json(const IdentificationResult& result, const MachineLibrary& machines) {
  const IdentificationOutcome& outcome = *result.outcome;
  QJsonArray recordings;
  for (const UsedRecording& recording : outcome.recordings) {
    recordings.append(to_json(recording));
  }
  QJsonArray models;
  for (const Identification& found : outcome.models) {
    models.append(to_json(found, machines));
  }
  QJsonObject json{{"date", as_text(outcome.date)},
                   {"program_sha256", QString::fromLatin1(outcome.program)},
                   {"recordings", recordings},
                   {"models", models},
                   {"chosen", static_cast<double>(result.chosen)},
                   {"stale", result.stale}};
  QJsonArray unfitted;
  for (const UnfittedModel& one : outcome.unfitted) {
    unfitted.append(QJsonObject{{"title", as_text(one.title)}, {"reason", as_text(one.reason.english())}});
  }
  if (!unfitted.isEmpty()) {
    json["unfitted"] = unfitted;
  }
  return json;
}

IdentificationResult read_result(const QJsonObject& json, const MachineLibrary& machines,
                                 QStringList& notes) {
  const QString whole = QStringLiteral("\"result\" of \"identification\"");
  note_unknown(json, {"date", "program_sha256", "recordings", "models", "chosen", "stale", "unfitted"}, whole,
               notes);
  auto outcome = std::make_shared<IdentificationOutcome>();
  outcome->date = json["date"].toString().toStdString();
  outcome->program = json["program_sha256"].toString().toLatin1();
  for (const QJsonValue& recording : json["recordings"].toArray()) {
    outcome->recordings.push_back(
        read_recording(recording.toObject(), whole + QStringLiteral(", \"recordings\""), notes));
  }
  for (const QJsonValue& model : json["models"].toArray()) {
    const QString place = QStringLiteral("%1, model %2").arg(whole).arg(outcome->models.size() + 1);
    outcome->models.push_back(
        read_model(model.toObject(), place, outcome->recordings.size(), machines, notes));
  }
  if (outcome->models.empty() || outcome->recordings.empty()) {
    throw input_error(whole + QStringLiteral(" has no \"models\" or no \"recordings\""));
  }
  for (const QJsonValue& one : json["unfitted"].toArray()) {
    outcome->unfitted.push_back({one["title"].toString().toStdString(),
                                 Message::as_written(one["reason"].toString().toStdString()), ""});
  }
  const std::size_t chosen = std::min(count_of(json["chosen"]), outcome->models.size() - 1);
  return {std::move(outcome), chosen, json["stale"].toBool()};
}

}  // namespace feedscope::ui
