#pragma once

#include <QString>
#include <filesystem>

namespace feedscope::ui {

/// A file's name for people and for Qt, with the separators of the system.
inline QString to_qstring(const std::filesystem::path& path) {
  return QString::fromStdU16String(path.u16string());
}

inline std::filesystem::path to_path(const QString& file) {
  return std::filesystem::path(file.toStdU16String());
}

}  // namespace feedscope::ui
