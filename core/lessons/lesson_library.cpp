#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/lessons/lesson.h"
#include "core/machine/config_file.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

constexpr const char* lessons_folder = "resources/lessons";

/// Whether `name` denotes a lesson: "04_small_circle" is also 4, 04 and small_circle.
bool is_called(const std::string& id, const std::string& name) {
  const std::size_t underscore = id.find('_');
  if (id == name || underscore == std::string::npos || id.substr(underscore + 1) == name) {
    return id == name || underscore != std::string::npos;
  }
  const auto number = [](const std::string& text) {
    int value = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : -1;
  };
  return number(name) >= 0 && number(name) == number(id.substr(0, underscore));
}

/// Lesson file for each id: of a shipped lesson, or of an earlier one that it replaces.
std::map<std::string, fs::path> files_by_id() {
  std::map<std::string, fs::path> files;
  for (const fs::path& file : shipped_lessons()) {
    files[file.stem().string()] = file;
    const ConfigNode root = read_config_file(file, NC_("core", "lesson"));
    if (const ConfigNode* replaces = root.find("replaces")) {
      for (const ConfigNode& earlier : replaces->items()) {
        files.emplace(earlier.text(), file);
      }
    }
  }
  return files;
}

/// Nearest id; none for an unknown number.
std::string nearest_id(const std::string& word, const std::vector<std::string>& ids) {
  if (word.find_first_not_of("0123456789") == std::string::npos) {
    return "";
  }
  std::vector<std::string> names;  // without numbers
  for (const std::string& id : ids) {
    names.push_back(id.substr(id.find('_') + 1));
  }
  const auto found = std::find(names.begin(), names.end(), nearest_name(word, names));
  return found != names.end() ? ids[static_cast<std::size_t>(found - names.begin())]
                              : nearest_name(word, ids);
}

}  // namespace

std::vector<fs::path> shipped_lessons() {
  std::vector<fs::path> files;
  const fs::path folder = data_folder() / lessons_folder;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".toml") {
      files.push_back(entry.path());
    }
  }
  if (error) {
    throw InputError(
        message(NC_("core", "cannot read lesson folder '{}': {}"), folder.string(), error.message()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

fs::path find_lesson(const std::string& id_or_file) {
  std::vector<std::string> ids;
  for (const fs::path& file : shipped_lessons()) {
    ids.push_back(file.stem().string());
    if (is_called(ids.back(), id_or_file)) {
      return file;
    }
  }
  std::error_code ignored;
  if (fs::exists(id_or_file, ignored)) {
    return id_or_file;
  }
  const std::map<std::string, fs::path> files = files_by_id();
  std::vector<std::string> all;
  for (const auto& [id, file] : files) {
    all.push_back(id);
    if (is_called(id, id_or_file)) {
      return file;
    }
  }
  const std::string nearest = nearest_id(id_or_file, all);
  throw InputError(message(
      NC_("core", "unknown lesson '{}': no id and no file; {}"), id_or_file,
      nearest.empty() ? message(NC_("core", "numbers 1 to {}, or ids: {}"), ids.size(),
                                fmt::format("{}", fmt::join(ids, ", ")))
                      : message(NC_("core", "did you mean '{}'?"), files.at(nearest).stem().string())));
}

}  // namespace feedscope
