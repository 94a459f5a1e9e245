#pragma once

#include "core/machine/settings.h"
#include "core/models/guarantees.h"

namespace feedscope {

/// `beta` of CornerRule: share of the contour tolerance used by blends of a Sinumerik 840D.
SettingSpec used_tolerance_setting();

/// Promises that corners stay within `factor` times the contour tolerance; with a tolerance of 0, that the
/// path is followed exactly, with full stops in corners of lines.
void promise_tolerance(Guarantees& promised, const Settings& settings, double factor);

/// Promises the axes' limits that lower_curve_ceilings() keeps on the curves of a compressor, if there is
/// one.
void promise_smooth_curves(Guarantees& promised, const Settings& settings);

}  // namespace feedscope
