#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// Machine data of a Sinumerik 840D, 840D sl, 828D or ONE as text: an archive, a file of machine data (TEA),
/// or lines of them. Of values by dynamic mode that of DYNNORM is used. Source: Siemens, SINUMERIK 840D sl /
/// 840Di sl / 840D, "Detailed Machine Data Description" (AMD), MD10071, 20050 to 20080, 20170, 20600, 29000,
/// 30300, 32000, 32200, 32300, 32431, 32610, 32620, 32810, 33100.
extern const ConfigurationFormat sinumerik_data;

}  // namespace feedscope
