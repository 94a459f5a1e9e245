#pragma once

#include "core/base/dimension.h"

namespace feedscope::ui {

/// In which all numbers are shown: on screen, in pictures and in reports. Files keep their own units.
UnitSystem unit_system();
/// Before windows, pictures and reports are made; what exists keeps its texts.
void use_unit_system(UnitSystem system);

/// The unit in which numbers of a dimension are shown.
const ShownUnit& shown(Dimension dimension);

}  // namespace feedscope::ui
