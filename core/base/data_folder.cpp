#include "core/base/data_folder.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/this_process.h"

namespace feedscope {
namespace fs = std::filesystem;
namespace {

bool holds_data(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "machines", ignored);
}

}  // namespace

fs::path data_folder() {
  if (const auto given = path_in_environment("FEEDSCOPE_DATA")) {
    if (!holds_data(*given)) {
      throw InputError(fmt::format(
          "FEEDSCOPE_DATA is '{}', which has no folder machines/; set it to Feedscope's data folder",
          given->string()));
    }
    return *given;
  }
  if (const fs::path executable = executable_path(); !executable.empty()) {
    fs::path installed = executable.parent_path().parent_path() / "share" / "feedscope";
    if (holds_data(installed)) {
      return installed;
    }
  }
  if (holds_data(FEEDSCOPE_DATA_DIR)) {
    return FEEDSCOPE_DATA_DIR;
  }
  throw InputError(
      fmt::format("data folder not found: neither ../share/feedscope next to the executable nor '{}' "
                  "contains machines/; set FEEDSCOPE_DATA to the folder that does",
                  FEEDSCOPE_DATA_DIR));
}

}  // namespace feedscope
