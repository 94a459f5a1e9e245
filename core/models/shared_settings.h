#pragma once

#include "core/machine/settings.h"
#include "core/models/guarantees.h"

namespace feedscope {

/// `beta` of CornerRule: the share of the contour tolerance that blends of a Sinumerik 840D use.
SettingSpec used_tolerance_setting();

/// Promises that corners lie within `factor` times the contour tolerance; with a tolerance of 0, that the
/// path is followed exactly, with full stops in corners of lines.
void promise_tolerance(Guarantees& promised, const Settings& settings, double factor);

/// Promises what lower_curve_ceilings() keeps of the axes' limits on the curves of a compressor, if there is
/// one.
void promise_smooth_curves(Guarantees& promised, const Settings& settings);

}  // namespace feedscope
