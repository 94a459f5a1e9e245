#pragma once

#include <QJsonObject>
#include <filesystem>
#include <string>
#include <vector>

#include "core/program/program.h"

namespace feedscope::ui {

/// Options that differ from the defaults; the path of a tool table is relative to `folder`.
QJsonObject to_json(const ReadOptions& options, const std::filesystem::path& folder);

/// Throws InputError naming key and value: an unknown dialect, a limit or radius out of bounds.
ReadOptions read_reading(const QJsonObject& json, const std::filesystem::path& folder);

std::vector<std::string> reading_keys();

}  // namespace feedscope::ui
