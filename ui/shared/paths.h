#pragma once

#include <QString>
#include <filesystem>
#include <type_traits>

namespace feedscope::ui {

/// Whether file names are bytes, as on Linux, where they are read as UTF-8. Invalid UTF-8 becomes replacement
/// characters; the conversions of std::filesystem would throw.
inline constexpr bool paths_are_bytes = std::is_same_v<std::filesystem::path::value_type, char>;

/// A file's name for people and for Qt, with the separators of the system.
inline QString to_qstring(const std::filesystem::path& path) {
  if constexpr (paths_are_bytes) {
    return QString::fromStdString(path.string());
  }
  return QString::fromStdU16String(path.u16string());
}

/// With separators that are equal on every system.
inline QString to_portable_qstring(const std::filesystem::path& path) {
  if constexpr (paths_are_bytes) {
    return QString::fromStdString(path.generic_string());
  }
  return QString::fromStdU16String(path.generic_u16string());
}

inline std::filesystem::path to_path(const QString& file) {
  if constexpr (paths_are_bytes) {
    return {file.toStdString()};
  }
  return {file.toStdU16String()};
}

}  // namespace feedscope::ui
