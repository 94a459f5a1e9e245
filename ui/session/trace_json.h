#pragma once

#include <QJsonObject>
#include <filesystem>
#include <string>
#include <vector>

#include "ui/workbench/trace_item.h"

namespace feedscope::ui {

/// File relative to `folder`, columns if chosen, name, colour and visibility.
QJsonObject to_json(const TraceItem& trace, const std::filesystem::path& folder);

/// `place`: of the trace and its file, for messages. Throws InputError if no file is given.
TraceItem read_trace_item(const QJsonObject& json, const QString& place, const std::filesystem::path& folder);

std::vector<std::string> trace_keys();

}  // namespace feedscope::ui
