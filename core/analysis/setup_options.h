#pragma once

#include <string>

#include "core/analysis/run.h"

namespace feedscope {

/// KEY=VALUE as --set has it.
std::string assignment_text(const std::string& key, const SettingValue& value);

/// All that the command line needs to ask for a setup on a shipped machine: --machine, --model where it is
/// not the machine's own, --tolerance and --set of what differs from the machine's file; the load is not
/// asked for. Throws InputError for a machine that is not shipped.
std::string setup_options(const Setup& setup);

}  // namespace feedscope
