#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// Klipper's printer.cfg with the files that it includes and the part written by SAVE_CONFIG. Source:
/// Klipper, "Configuration reference", [printer] and [gcode_arcs] (klipper3d.org).
extern const ConfigurationFormat klipper_config;

}  // namespace feedscope
