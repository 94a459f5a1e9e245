#pragma once

#include "core/machine/settings.h"

namespace feedscope {

/// `beta` of CornerRule: the share of the contour tolerance that blends of a Sinumerik 840D use.
SettingSpec used_tolerance_setting();

}  // namespace feedscope
