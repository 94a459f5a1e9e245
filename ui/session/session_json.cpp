#include "ui/session/session_json.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "ui/scene_view/scene_json.h"
#include "ui/session/identification_json.h"
#include "ui/session/lessons_json.h"
#include "ui/session/reading_json.h"
#include "ui/session/setup_json.h"
#include "ui/session/trace_json.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {
namespace {

constexpr const char* format_name = "feedscope-session";
constexpr int largest_text_size = 200;  // [points]

/// A colour in the form #rrggbb: without transparency, eight bits per channel.
QColor colour_of(const QJsonValue& json) {
  const QColor colour(json.toString());
  return colour.isValid() ? QColor(colour.rgb()) : colour;
}

}  // namespace

void note_unknown(const QJsonObject& json, const std::vector<std::string>& known, const QString& place,
                  QStringList& notes) {
  for (const QString& key : json.keys()) {
    const std::string name = key.toStdString();
    if (std::ranges::find(known, name) != known.end()) {
      continue;
    }
    const std::string near = nearest_name(name, known);
    notes.append(QStringLiteral("%1 has an unknown key \"%2\"; it is ignored%3")
                     .arg(place, key,
                          near.empty()
                              ? QString()
                              : QStringLiteral(" (did you mean \"%1\"?)").arg(QString::fromStdString(near))));
  }
}

namespace {

// ---- Runs

QJsonObject to_json(const RunItem& run, const MachineLibrary& machines) {
  QJsonObject json = to_json(run.setup, machines);
  json["name"] = run.name;
  json["colour"] = run.colour.name();
  json["visible"] = run.visible;
  return json;
}

RunItem read_run(const QJsonObject& json, const QString& place, const MachineLibrary& machines,
                 QStringList& notes) {
  note_unknown(json, {"name", "colour", "visible", "machine", "machine_file", "model", "set"}, place, notes);
  RunItem run{0, json["name"].toString(), colour_of(json["colour"]), json["visible"].toBool(true),
              read_setup(json, place, machines)};
  if (!run.colour.isValid()) {
    run.colour = QColor(Qt::darkBlue);
  }
  return run;
}

// ---- Cutting load

/// The lines of a load file; none without operations.
QJsonArray to_json(const LoadSetup& load) {
  return load.empty() ? QJsonArray()
                      : QJsonArray::fromStringList(QString::fromStdString(load_file_text(load)).split('\n'));
}

LoadSetup read_load(const QJsonValue& json) {
  const QString text = json.toVariant().toStringList().join('\n');
  return text.isEmpty() ? LoadSetup() : parse_load(text.toStdString(), "load_file of the session", true);
}

// ---- Annotations

QJsonObject to_json(const ProgrammedPlace& place) {
  return {{"segment", static_cast<double>(place.segment)}, {"share", place.share}};
}

ProgrammedPlace read_place(const QJsonObject& json, const QString& place) {
  const double segment = json["segment"].toDouble(-1);
  const double share = json["share"].toDouble();
  if (!(segment >= 0 && segment <= 4294967295.0 && segment == std::floor(segment))) {
    throw input_error(QStringLiteral("%1: \"segment\" must be a whole number from 0").arg(place));
  }
  if (!(share >= 0 && share <= 1)) {
    throw input_error(QStringLiteral("%1: \"share\" is %2; it must be from 0 to 1").arg(place).arg(share));
  }
  return {static_cast<std::uint32_t>(segment), share};
}

QJsonObject to_json(const Annotation& annotation) {
  QJsonObject json{{"kind", annotation_key(annotation.kind)},
                   {"place", to_json(annotation.place)},
                   {"text", annotation.text},
                   {"offset_px", QJsonArray{annotation.offset.x(), annotation.offset.y()}},
                   {"colour", annotation.colour.name()},
                   {"size_pt", annotation.size}};
  if (!annotation.view.isEmpty()) {
    json["view_px"] = QJsonArray{annotation.view.width(), annotation.view.height()};
  }
  if (has_two_places(annotation.kind)) {
    json["until"] = to_json(annotation.until);
  }
  return json;
}

AnnotationKind read_kind(const QJsonValue& json, const QString& place) {
  QStringList known;
  for (const AnnotationKind kind : annotation_kinds) {
    if (json.toString() == annotation_key(kind)) {
      return kind;
    }
    known.append(annotation_key(kind));
  }
  throw input_error(QStringLiteral("%1: \"kind\" is \"%2\"; it must be one of %3")
                        .arg(place, json.toString(), known.join(QStringLiteral(", "))));
}

Annotation read_annotation(const QJsonObject& json, const QString& place, QStringList& notes) {
  note_unknown(json, {"kind", "place", "until", "text", "offset_px", "view_px", "colour", "size_pt"}, place,
               notes);
  Annotation annotation;
  annotation.kind = read_kind(json["kind"], place);
  annotation.place = read_place(json["place"].toObject(), place + QStringLiteral(", place"));
  annotation.until = has_two_places(annotation.kind)
                         ? read_place(json["until"].toObject(), place + QStringLiteral(", until"))
                         : annotation.place;
  annotation.text = json["text"].toString();
  const QJsonArray offset = json["offset_px"].toArray();
  if (offset.size() == 2) {
    annotation.offset = {offset[0].toDouble(), offset[1].toDouble()};
  }
  const QJsonArray view = json["view_px"].toArray();
  if (view.size() == 2 && view[0].toDouble() > 0 && view[1].toDouble() > 0) {
    annotation.view = {view[0].toDouble(), view[1].toDouble()};
  }
  if (const QColor colour = colour_of(json["colour"]); colour.isValid()) {
    annotation.colour = colour;
  }
  annotation.size = json["size_pt"].toDouble(annotation.size);
  if (!(annotation.size > 0 && annotation.size <= largest_text_size)) {
    throw input_error(QStringLiteral("%1: \"size_pt\" is %2; it must be above 0 and at most %3")
                          .arg(place)
                          .arg(annotation.size)
                          .arg(largest_text_size));
  }
  return annotation;
}

// ---- The whole

void check_format(const QJsonObject& json) {
  if (json["format"] != QLatin1String(format_name)) {
    throw InputError(message(NC_("core", "it is not a Feedscope session: its \"format\" is not \"{}\""),
                             std::string_view(format_name)));
  }
  const double version = json["version"].toDouble();
  if (version > session_version) {
    throw InputError(message(
        NC_("core", "it is of version {}, written by a newer Feedscope; this one reads up to version {}"),
        version, session_version));
  }
  if (version != session_version) {
    throw InputError(
        message(NC_("core", "its \"version\" is not a whole number from 1 to {}"), session_version));
  }
}

void read_window(const QJsonObject& json, Session& session, QStringList& notes) {
  note_unknown(json, {"layout", "presentation", "theme", "program_font_px"}, QStringLiteral("\"window\""),
               notes);
  session.layout = QByteArray::fromBase64(json["layout"].toString().toLatin1());
  session.presentation = json["presentation"].toBool();
  if (json.contains("theme")) {
    session.theme = json["theme"] == QLatin1String("dark") ? ThemeKind::dark : ThemeKind::light;
  }
  if (json["program_font_px"].isDouble()) {
    session.program_font_size = json["program_font_px"].toInt();
  }
}

}  // namespace

QJsonObject to_json(const Session& session, const std::filesystem::path& folder) {
  const MachineLibrary machines = shipped_machines();
  QJsonArray runs;
  for (const RunItem& run : session.runs) {
    runs.append(to_json(run, machines));
  }
  QJsonArray annotations;
  for (const Annotation& annotation : session.annotations) {
    annotations.append(to_json(annotation));
  }
  QJsonArray traces;
  for (const TraceItem& trace : session.traces) {
    traces.append(to_json(trace, folder));
  }
  const std::filesystem::path relative = session.program.lexically_relative(folder);
  QJsonObject window;
  if (!session.layout.isEmpty()) {
    window["layout"] = QString::fromLatin1(session.layout.toBase64());
  }
  if (session.presentation) {
    window["presentation"] = true;
  }
  if (session.theme) {
    window["theme"] = *session.theme == ThemeKind::dark ? "dark" : "light";
  }
  if (session.program_font_size) {
    window["program_font_px"] = *session.program_font_size;
  }
  QJsonObject json{
      {"format", format_name},
      {"version", session_version},
      {"program", QJsonObject{{"file", to_portable_qstring(relative.empty() ? session.program : relative)},
                              {"sha256", QString::fromLatin1(session.program_hash)}}},
      {"reading", to_json(session.reading, folder)},
      {"runs", runs},
      {"current_run", static_cast<int>(session.current_run)},
      {"cursor_s", session.cursor},
      {"view", to_json(session.scene)},
      {"compare", to_json(session.scenes)},
      {"charts", to_json(session.charts)},
      {"circular", to_json(session.circular)},
      {"load_file", to_json(session.load)},
      {"annotations", annotations},
      {"traces", traces},
      {"window", window}};
  put_lessons(session.lessons, json);
  if (session.lessons_unlocked) {
    json["lessons_unlocked"] = true;
  }
  if (session.error_bound) {
    json["max_contour_error_mm"] = *session.error_bound;
  }
  if (const QJsonObject found = to_json(session.identification, folder, machines); !found.isEmpty()) {
    json["identification"] = found;
  }
  return json;
}

QJsonObject lesson_work_json(const LessonWork& work) {
  QJsonObject json{{"format", format_name}, {"version", session_version}};
  put_lessons(work, json);
  return json;
}

LessonWork read_lesson_work(const QJsonObject& json) {
  check_format(json);
  QStringList notes;
  return read_lessons(json, notes);
}

ReadSession read_session(const QJsonObject& json, const std::filesystem::path& folder,
                         const MachineLibrary& machines) {
  check_format(json);
  ReadSession read;
  note_unknown(json, {"format",           "version",     "program",
                      "reading",          "runs",        "current_run",
                      "cursor_s",         "view",        "compare",
                      "charts",           "circular",    "load_file",
                      "annotations",      "traces",      "identification",
                      "lessons",          "predictions", "transfers",
                      "lessons_unlocked", "window",      "max_contour_error_mm"},
               QStringLiteral("the session"), read.notes);
  Session& session = read.session;
  const QJsonObject program = json["program"].toObject();
  note_unknown(program, {"file", "sha256"}, QStringLiteral("\"program\""), read.notes);
  if (program["file"].toString().isEmpty()) {
    throw InputError(NC_("core", "it names no program: \"program\" has no \"file\""));
  }
  session.program = (folder / to_path(program["file"].toString())).lexically_normal();
  session.program_hash = program["sha256"].toString().toLatin1();
  note_unknown(json["reading"].toObject(), reading_keys(), QStringLiteral("\"reading\""), read.notes);
  session.reading = read_reading(json["reading"].toObject(), folder);
  int number = 0;
  for (const QJsonValue& run : json["runs"].toArray()) {
    session.runs.push_back(
        read_run(run.toObject(), QStringLiteral("run %1").arg(++number), machines, read.notes));
  }
  if (session.runs.empty()) {
    throw InputError(NC_("core", "it has no runs: \"runs\" is empty or missing"));
  }
  session.current_run = static_cast<std::size_t>(
      std::clamp(json["current_run"].toInt(), 0, static_cast<int>(session.runs.size()) - 1));
  session.cursor = json["cursor_s"].toDouble();
  if (const double bound = json["max_contour_error_mm"].toDouble(); bound > 0 && std::isfinite(bound)) {
    session.error_bound = bound;
  }
  read_json(json["view"].toObject(), session.scene);
  note_unknown(json["compare"].toObject(), {"mode", "other_run", "split", "reference_run"},
               QStringLiteral("\"compare\""), read.notes);
  read_json(json["compare"].toObject(), session.scenes);
  read_json(json["charts"].toObject(), session.charts);
  note_unknown(json["circular"].toObject(),
               {"source", "radii_mm", "feeds_mm_min", "plane", "entry_arc", "entry_radius_mm"},
               QStringLiteral("\"circular\""), read.notes);
  read_json(json["circular"].toObject(), session.circular);
  session.load = read_load(json["load_file"]);
  number = 0;
  for (const QJsonValue& annotation : json["annotations"].toArray()) {
    session.annotations.push_back(
        read_annotation(annotation.toObject(), QStringLiteral("annotation %1").arg(++number), read.notes));
  }
  number = 0;
  for (const QJsonValue& trace : json["traces"].toArray()) {
    const QString place = QStringLiteral("trace %1").arg(++number);
    note_unknown(trace.toObject(), trace_keys(), place, read.notes);
    session.traces.push_back(read_trace_item(trace.toObject(), place, folder));
  }
  session.identification =
      read_identification(json["identification"].toObject(), folder, machines, read.notes);
  session.lessons = read_lessons(json, read.notes);
  session.lessons_unlocked = json["lessons_unlocked"].toBool();
  read_window(json["window"].toObject(), session, read.notes);
  return read;
}

}  // namespace feedscope::ui
