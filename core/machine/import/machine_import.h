#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/machine/machine.h"

namespace feedscope {

/// A machine made from the configuration of its control.
struct ImportedMachine {
  Machine machine;   ///< every number with file and line as its source, or assumed with a reason
  std::string kind;  ///< of the configuration, for display: "INI file of LinuxCNC"
  /// Parts that were not understood, contradict each other or that no model supports, in the order of the
  /// files. An error: a value that could not be used, or that the control itself would refuse.
  std::vector<Diagnostic> notes;
};

/// Kind of configuration of a text, for display: "INI file of LinuxCNC". "" for every other text, including
/// NC programs.
std::string configuration_kind(std::string_view text);
/// Kind of a file of at most 4 MiB, from its first 256 KiB; "" for other files and unreadable ones.
std::string configuration_kind_of(const std::filesystem::path& file);

/// Makes a machine from a configuration, recognised by its content: INI of LinuxCNC, listing of grbl ($$),
/// printer.cfg of Klipper, listing of Marlin (M503), machine data of a Sinumerik, parameters of a Fanuc or a
/// Heidenhain. Reads included files too. The name of the file without its extension becomes the machine's id.
/// `model_settings`: as for read_machine(). Throws InputError for a file that cannot be read or is none of
/// these.
ImportedMachine import_machine(const std::filesystem::path& file,
                               const std::vector<SettingSpec>& model_settings);
/// Makes a machine from a text; `name` replaces the file in sources and messages, and nothing is included.
ImportedMachine import_machine_text(std::string_view text, const std::string& name,
                                    const std::vector<SettingSpec>& model_settings);

}  // namespace feedscope
