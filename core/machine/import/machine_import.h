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
  Machine machine;   ///< every number with file and line as its source, or assumed with the reason
  std::string kind;  ///< of the configuration, for people: "INI file of LinuxCNC"
  /// What was not understood, what contradicts itself and what no model shows, in the order of the files.
  /// An error: a value that could not be used, or what the control itself would refuse.
  std::vector<Diagnostic> notes;
};

/// What a text is the configuration of, for people: "INI file of LinuxCNC". "" for every other text, NC
/// programs among them.
std::string configuration_kind(std::string_view text);
/// The same of the first 256 KiB of a file of at most 4 MiB; "" for another one, or one that cannot be read.
std::string configuration_kind_of(const std::filesystem::path& file);

/// Makes a machine from a configuration, found by its content: INI of LinuxCNC, listing of grbl ($$),
/// printer.cfg of Klipper, listing of Marlin (M503), machine data of a Sinumerik, parameters of a Fanuc or a
/// Heidenhain. Files that it includes are read too. The name of the file without its ending becomes the
/// machine's id. `model_settings`: as for read_machine(). Throws InputError for a file that cannot be read or
/// is none of these.
ImportedMachine import_machine(const std::filesystem::path& file,
                               const std::vector<SettingSpec>& model_settings);
/// The same of a text; `name` stands for the file in sources and messages, and nothing is included.
ImportedMachine import_machine_text(std::string_view text, const std::string& name,
                                    const std::vector<SettingSpec>& model_settings);

}  // namespace feedscope
