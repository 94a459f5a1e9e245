#pragma once

#include "core/base/dimension.h"

namespace feedscope::ui {

/// The unit system of all shown numbers: on screen, in pictures and in reports. Files keep their own units.
UnitSystem unit_system();
/// Call before windows, pictures and reports are made; existing ones keep their texts.
void use_unit_system(UnitSystem system);

const ShownUnit& shown(Dimension dimension);

}  // namespace feedscope::ui
