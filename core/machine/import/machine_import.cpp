#include "core/machine/import/machine_import.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "core/base/error.h"
#include "core/machine/file_text.h"
#include "core/machine/import/configuration_source.h"
#include "core/machine/import/fanuc_parameters.h"
#include "core/machine/import/grbl_listing.h"
#include "core/machine/import/heidenhain_parameters.h"
#include "core/machine/import/klipper_config.h"
#include "core/machine/import/linuxcnc_ini.h"
#include "core/machine/import/machine_draft.h"
#include "core/machine/import/marlin_report.h"
#include "core/machine/import/sinumerik_data.h"

namespace feedscope {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_configuration = 4;  // MiB
const std::array<const ConfigurationFormat*, 7> formats{
    &linuxcnc_ini,   &grbl_listing,     &klipper_config,       &marlin_report,
    &sinumerik_data, &fanuc_parameters, &heidenhain_parameters};

/// Format with the most typical lines in the text; null if there is none.
const ConfigurationFormat* format_of(std::string_view text) {
  const ConfigurationFormat* best = nullptr;
  std::size_t most = 0;
  if (text.find('\0') != std::string_view::npos) {
    return nullptr;
  }
  for (const ConfigurationFormat* format : formats) {
    const std::size_t lines = format->recognised(text);
    if (lines > most) {
      best = format;
      most = lines;
    }
  }
  return best;
}

/// Machine id from a file name such as "my-mill.ini".
std::string id_of(const std::string& name) {
  std::string id = fs::path(name).stem().string();
  std::ranges::replace_if(
      id, [](char c) { return c == ' ' || c == '\t'; }, '-');
  return id.empty() ? "imported" : id;
}

ImportedMachine import_from(std::string_view bytes, const fs::path& folder, const std::string& name,
                            const std::vector<SettingSpec>& model_settings) {
  const std::string text = utf8_text(bytes);
  const ConfigurationFormat* format = format_of(text);
  if (format == nullptr) {
    std::vector<Message> kinds;
    for (const ConfigurationFormat* known : formats) {
      kinds.emplace_back(Translatable{known->kind});
    }
    throw InputError(
        message(NC_("core", "'{}' is not the configuration of a control that can be imported; known: {}"),
                name, enumerated(kinds)));
  }
  MachineDraft draft(utf8_text(fs::path(name).filename().string()), model_settings);
  draft.machine().id = utf8_text(id_of(name));
  draft.machine().name = draft.machine().id;
  return format->read({text, folder}, std::move(draft));
}

}  // namespace

std::string configuration_kind(std::string_view text) {
  const ConfigurationFormat* format = format_of(utf8_text(text));
  return format == nullptr ? "" : format->kind;
}

std::string configuration_kind_of(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (error || size > (largest_configuration << 20)) {
    return "";
  }
  constexpr std::size_t looked_at = 1 << 18;  // bytes
  std::string text(std::min<std::size_t>(size, looked_at), '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() < size) {
    text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n'));
  }
  return configuration_kind(text);
}

ImportedMachine import_machine(const fs::path& file, const std::vector<SettingSpec>& model_settings) {
  const std::string text = file_text(file, NC_("core", "configuration of a control"), largest_configuration);
  const fs::path folder = file.parent_path();
  return import_from(text, folder.empty() ? fs::path(".") : folder, file.string(), model_settings);
}

ImportedMachine import_machine_text(std::string_view text, const std::string& name,
                                    const std::vector<SettingSpec>& model_settings) {
  return import_from(text, {}, name, model_settings);
}

}  // namespace feedscope
