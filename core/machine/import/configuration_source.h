#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace feedscope {

class MachineDraft;
struct ImportedMachine;

/// A configuration that is to be read.
struct ConfigurationSource {
  std::string_view text;
  std::filesystem::path folder;  ///< where files that it includes are looked for; empty: nothing is included
};

/// One kind of configuration.
struct ConfigurationFormat {
  const char* kind;  ///< for people: "INI file of LinuxCNC"
  /// How many lines speak for this kind; 0: it is another one.
  std::size_t (*recognised)(std::string_view text);
  ImportedMachine (*read)(const ConfigurationSource& source, MachineDraft draft);
};

}  // namespace feedscope
