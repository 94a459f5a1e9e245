#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// Listing of the settings of grbl 1.1 or 0.9 ($$), with what senders write around it; of grblHAL and FluidNC
/// as far as they name the same. The start-up message and the lines of $I tell the firmware and its buffer.
/// Sources: grbl, wiki, "Grbl v1.1 Configuration" and "Interface"; grblHAL, wiki, "Additional or extended
/// settings"; FluidNC, wiki, "Configuration".
extern const ConfigurationFormat grbl_listing;

}  // namespace feedscope
