#pragma once

#include <vector>

namespace feedscope::samples {

/// Parameters u in [0, 1] of the points of essid_spline(), ends included: from each point the chord goes as
/// far as its distance from the cubic stays within `tolerance` [mm].
std::vector<double> spline_parameters(double tolerance);

}  // namespace feedscope::samples
