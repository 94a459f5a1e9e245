#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// INI file of LinuxCNC, 2.4 to 2.10: axes from [AXIS_X] (before 2.8 [AXIS_0] ...), or from the joints where
/// these have no values; units from [TRAJ] LINEAR_UNITS. Source: LinuxCNC, User Manual, "INI Configuration"
/// (linuxcnc.org/docs).
extern const ConfigurationFormat linuxcnc_ini;

}  // namespace feedscope
