#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// printer.cfg of Klipper with the files that it includes and the part that SAVE_CONFIG writes.
/// Source: Klipper, "Configuration reference", [printer] and [gcode_arcs] (klipper3d.org).
extern const ConfigurationFormat klipper_config;

}  // namespace feedscope
