#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/machine/machine.h"

namespace feedscope {
namespace fs = std::filesystem;

MachineLibrary::MachineLibrary(fs::path folder, std::vector<SettingSpec> model_settings)
    : folder_(std::move(folder)), model_settings_(std::move(model_settings)) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    if (entry.path().extension() == ".toml") {
      ids_.push_back(entry.path().stem().string());
    }
  }
  if (error) {
    throw InputError(
        message(NC_("core", "cannot read machine folder '{}': {}"), folder_.string(), reason_of(error)));
  }
  std::sort(ids_.begin(), ids_.end());
}

Machine MachineLibrary::load(const std::string& id_or_file) const {
  if (std::binary_search(ids_.begin(), ids_.end(), id_or_file)) {
    return read_machine(folder_ / (id_or_file + ".toml"), model_settings_);
  }
  std::error_code ignored;
  if (fs::exists(id_or_file, ignored)) {
    return read_machine(id_or_file, model_settings_);
  }
  const std::string nearest = nearest_name(id_or_file, ids_);
  throw InputError(
      message(NC_("core", "unknown machine '{}': neither a machine id nor a file; {}"), id_or_file,
              nearest.empty() ? message(NC_("core", "ids: {}"), fmt::to_string(fmt::join(ids_, ", ")))
                              : message(NC_("core", "did you mean '{}'?"), nearest)));
}

}  // namespace feedscope
