#pragma once

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// Machine parameters of a Heidenhain up to the iTNC 530, one per line: "MP1010.0 : 30000 ;comment". The
/// index is the axis; 0, 1 and 2 are assumed to be X, Y and Z. Source: Heidenhain, Technical Manual iTNC 530
/// HSCI (July 2013), section 6.8: MP1010 rapid traverse [mm/min], MP1060 acceleration [m/s2], MP1061
/// acceleration of the path, MP1085 jerk of an axis and MP1090.0 of all [m/s3].
extern const ConfigurationFormat heidenhain_parameters;

}  // namespace feedscope
