#pragma once

#include <QJsonObject>
#include <filesystem>
#include <string>
#include <vector>

#include "core/program/program.h"

namespace feedscope::ui {

/// What differs from the usual way to read a program; the path of a tool table relative to `folder`.
QJsonObject to_json(const ReadOptions& options, const std::filesystem::path& folder);

/// Throws InputError naming key and value: a dialect that is not known, a limit or radius out of bounds.
ReadOptions read_reading(const QJsonObject& json, const std::filesystem::path& folder);

std::vector<std::string> reading_keys();

}  // namespace feedscope::ui
