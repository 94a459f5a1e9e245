#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// Listing of the settings of Marlin (M503), or a file of such commands; with M566 that of RepRapFirmware,
/// whose velocities are in mm/min. There is no model of either: Klipper's is the nearest, with limits along
/// the path. Sources: Marlin, "G-code index", M92, M201, M203, M204, M205, M503 (marlinfw.org); Duet 3D,
/// "GCode dictionary", M201, M203, M204, M566.
extern const ConfigurationFormat marlin_report;

}  // namespace feedscope
