#include <fmt/format.h>

#include <algorithm>

#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/lessons/lesson.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

constexpr const char* programs_folder = "resources/programs";
constexpr const char* examples_folder = "resources/examples";

std::string value_of(const std::string& assignment) {
  return assignment.substr(assigned_key(assignment).size() + 1);
}

bool is_choice_of_run(const std::string& key) {
  return key == "program" || key == "machine" || key == "model";
}

/// Sets `value` to the last one for a key in `changes`, if any.
void take(const Changes& changes, const char* key, std::string& value) {
  for (const std::string& change : changes) {
    if (assigned_key(change) == key) {
      value = value_of(change);
    }
  }
}

std::vector<std::string> names_of_programs(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.is_regular_file(ignored) && entry.path().extension() != ".md") {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_program(const Lesson& lesson, const std::string& name) {
  const fs::path shipped = data_folder() / programs_folder;
  std::error_code ignored;
  for (const fs::path& folder : {lesson.file.parent_path(), shipped}) {
    if (!name.empty() && fs::is_regular_file(folder / name, ignored)) {
      return folder / name;
    }
  }
  const std::string nearest = nearest_name(name, names_of_programs(shipped));
  throw InputError(
      message(NC_("core", "program '{}' is neither next to the lesson nor in {}{}"), name,
              std::string_view(programs_folder),
              nearest.empty() ? Message() : message(NC_("core", "; did you mean '{}'?"), nearest)));
}

/// Sets `tolerance` as --tolerance does.
void apply_tolerance(const std::string& change, Setup& setup) {
  const auto& specs = common_settings();
  const auto spec = std::ranges::find(specs, contour_tolerance_key, &SettingSpec::key);
  set_tolerance(setup, std::get<double>(parse_setting(*spec, value_of(change))));
}

void apply(const Changes& changes, bool only_known, Setup& setup) {
  const std::vector<std::string> keys = assignable_keys(*setup.model);
  for (const std::string& change : changes) {
    if (is_choice_of_run(assigned_key(change))) {
      continue;
    }
    if (assigned_key(change) == "tolerance") {
      apply_tolerance(change, setup);
      continue;
    }
    const bool known = std::find(keys.begin(), keys.end(), assigned_key(change)) != keys.end();
    if (known || !only_known) {
      apply_setting(change, *setup.model, setup.machine, setup.settings);
    }
  }
}

}  // namespace

fs::path find_load_file(const Lesson& lesson, const std::string& name) {
  std::error_code ignored;
  const fs::path beside = lesson.file.parent_path() / name;
  return fs::is_regular_file(beside, ignored) ? beside : data_folder() / examples_folder / name;
}

LessonSetup set_up(const Lesson& lesson, const Changes& changes) {
  return LessonSetups().set_up(lesson, changes);
}

LessonSetup LessonSetups::set_up(const Lesson& lesson, const Changes& changes) {
  std::string program;
  SetupRequest request;
  for (const Changes* some : {&lesson.start, &changes}) {
    take(*some, "program", program);
    take(*some, "machine", request.machine);
    take(*some, "model", request.model);
  }
  std::string begins_with;
  take(lesson.start, "program", begins_with);
  fs::path file = find_program(lesson, program);
  const std::pair key(request.machine, request.model);
  auto known = files_.find(key);
  if (known == files_.end()) {
    known = files_.emplace(key, make_setup(request)).first;
  }
  LessonSetup result{std::move(file), known->second, {}};
  result.setup = result.file;
  if (program == begins_with) {  // a load file refers to tools and lines of its program
    result.setup.load = lesson.load;
  }
  apply(lesson.start, true, result.setup);
  apply(changes, false, result.setup);
  return result;
}

}  // namespace feedscope
