#pragma once

#include <string>

#include "core/base/geometry.h"
#include "core/machine/config_file.h"
#include "core/machine/machine.h"

namespace feedscope {

// Numbers of machine files with where they come from: { value = 20, source = "paper, table" }.

/// The one of "source" and "assumed" that the table `entry` has; `name` stands for it in messages. Throws
/// InputError if it has both or none.
Provenance read_provenance(const ConfigNode& entry, const std::string& name);

/// The key `spec` of `table`, called `where` in messages, with what it comes from in `provenance`. Throws
/// InputError if it is missing, has no source, or breaks `spec`.
SettingValue read_sourced_value(const ConfigNode& table, const SettingSpec& spec, const std::string& where,
                                Provenance& provenance);

/// Three numbers of `entry` under `keys`, each from -`most` to `most`. Throws InputError.
Vec3 read_vector(const ConfigNode& entry, const std::array<const char*, 3>& keys, double most,
                 const std::string& name);

/// A text as TOML writes it.
std::string toml_text(const std::string& text);
/// source = "paper, table", as Machine::provenance has it for `key`.
std::string toml_provenance(const Machine& machine, const std::string& key);
/// key = { value = ..., source = "..." } and the end of the line.
std::string toml_entry(const Machine& machine, const std::string& key, const std::string& provenance_key,
                       const SettingValue& value);

}  // namespace feedscope
