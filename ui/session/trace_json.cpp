#include "ui/session/trace_json.h"

#include "ui/session/session_json.h"
#include "ui/shared/paths.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

std::vector<std::string> trace_keys() {
  return {"file", "columns", "name", "colour", "visible"};
}

QJsonObject to_json(const TraceItem& trace, const std::filesystem::path& folder) {
  const std::filesystem::path relative = trace.file.lexically_relative(folder);
  QJsonObject json{{"file", to_portable_qstring(relative.empty() ? trace.file : relative)},
                   {"name", trace.name},
                   {"colour", trace.colour.name()},
                   {"visible", trace.visible}};
  if (!trace.columns.empty()) {
    json["columns"] = QString::fromStdString(trace.columns);
  }
  return json;
}

TraceItem read_trace_item(const QJsonObject& json, const QString& place,
                          const std::filesystem::path& folder) {
  const QString file = json["file"].toString();
  if (file.isEmpty()) {
    throw input_error(place + QStringLiteral(" names no file: it has no \"file\""));
  }
  TraceItem trace;
  trace.file = (folder / to_path(file)).lexically_normal();
  trace.columns = json["columns"].toString().toStdString();
  trace.name = json["name"].toString(to_qstring(trace.file.filename()));
  const QColor colour(json["colour"].toString());
  trace.colour = colour.isValid() ? QColor(colour.rgb()) : run_colour(0);
  trace.visible = json["visible"].toBool(true);
  return trace;
}

}  // namespace feedscope::ui
