#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace feedscope {

class MachineDraft;
struct ImportedMachine;

/// A configuration to read.
struct ConfigurationSource {
  std::string_view text;
  std::filesystem::path folder;  ///< searched for included files; empty: nothing is included
};

/// One kind of configuration.
struct ConfigurationFormat {
  const char* kind;  ///< for display: "INI file of LinuxCNC"
  /// Number of lines typical of this kind; 0 if it is another one.
  std::size_t (*recognised)(std::string_view text);
  ImportedMachine (*read)(const ConfigurationSource& source, MachineDraft draft);
};

}  // namespace feedscope
