#pragma once

#include <string>

#include "core/analysis/run/run.h"

namespace feedscope {

/// KEY=VALUE as for --set.
std::string assignment_text(const std::string& key, const SettingValue& value);

/// Command-line options for a setup on a shipped machine: --machine, --model unless it is the machine's own,
/// --tolerance and --set for values that differ from the machine's file. The load is not included. Throws
/// InputError for a machine that is not shipped.
std::string setup_options(const Setup& setup);

}  // namespace feedscope
