#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// Settings of Marlin as listed by M503, or a file of such commands; with M566 those of RepRapFirmware, whose
/// velocities are in mm/min. Neither has a model; Klipper's, with limits along the path, is the nearest.
/// Sources: Marlin, "G-code index", M92, M201, M203, M204, M205, M503 (marlinfw.org); Duet 3D, "GCode
/// dictionary", M201, M203, M204, M566.
extern const ConfigurationFormat marlin_report;

}  // namespace feedscope
