#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// Parameters of a Fanuc 0i-D, 0i-F or 30i as output by the control: "N01420A1P24000A2P24000A3P24000".
/// Source: Fanuc, Parameter Manual (B-64310EN of the 0i-D, B-64490EN of the 30i-B): 1001 metric or inch
/// machine, 1006 rotary axes, 1020 names of axes, 1420 rapid traverse [mm/min], 1432 cutting feed [mm/min],
/// 1660 acceleration before interpolation [mm/s2], 1772 time in which it changes [ms], 1825 gain of the
/// position loop [0.01/s].
extern const ConfigurationFormat fanuc_parameters;

}  // namespace feedscope
