#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// Settings of grbl 1.1 or 0.9 as listed by $$, with the output of senders around it; of grblHAL and FluidNC
/// where they use the same names. The start-up message and the lines of $I identify the firmware and its
/// buffer. Sources: grbl, wiki, "Grbl v1.1 Configuration" and "Interface"; grblHAL, wiki, "Additional or
/// extended settings"; FluidNC, wiki, "Configuration".
extern const ConfigurationFormat grbl_listing;

}  // namespace feedscope
