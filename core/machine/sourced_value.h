#pragma once

#include <string>

#include "core/base/geometry.h"
#include "core/machine/config_file.h"
#include "core/machine/machine.h"

namespace feedscope {

// Numbers of machine files with their sources: { value = 20, source = "paper, table" }.

/// Reads "source" or "assumed" of the table `entry`, called `name` in messages. Throws InputError if it has
/// both or none.
Provenance read_provenance(const ConfigNode& entry, const std::string& name);

/// Reads the key `spec` of `table`, called `where` in messages, and its source into `provenance`. Throws
/// InputError if it is missing, has no source, or violates `spec`.
SettingValue read_sourced_value(const ConfigNode& table, const SettingSpec& spec, const std::string& where,
                                Provenance& provenance);

/// Reads three numbers of `entry` under `keys`, each from -`most` to `most`. Throws InputError.
Vec3 read_vector(const ConfigNode& entry, const std::array<const char*, 3>& keys, double most,
                 const std::string& name);

/// A text in TOML syntax.
std::string toml_text(const std::string& text);
/// Entry source = "paper, table", from Machine::provenance for `key`.
std::string toml_provenance(const Machine& machine, const std::string& key);
/// Line key = { value = ..., source = "..." }.
std::string toml_entry(const Machine& machine, const std::string& key, const std::string& provenance_key,
                       const SettingValue& value);

}  // namespace feedscope
