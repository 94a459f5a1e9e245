#pragma once

#include <QString>

#include "core/analysis/contour/contour_report.h"

namespace feedscope::ui {

// What is said of contour errors on screen; numbers by the locale and the unit system.

/// "28.3", with one digit more below 10 µm and two below 1 µm.
QString error_text(double mm);
/// "28.3 µm".
QString error_amount_text(double mm);
/// "12 (N120)".
QString line_text(const ContourFinding& finding);
/// "left", "right"; "–" where the deviation is not in XY.
QString side_text(const ContourPlace& place);
/// "Corner of 90°, inside", "Arc R 5 mm, inside", "Line of 0.2 mm".
QString spot_text(const ContourSpot& spot);
/// How large, where, when, and against which tolerance, in one or two sentences.
QString verdict_text(const ContourReport& report);
/// How much of the path has hardly any error. `sides`: where left and right are shown and the largest error
/// is neither, that too.
QString share_text(const ContourReport& report, bool sides);

/// The error that the path exceeds on no more than a `share` of its length [mm], up to a step of the spread.
double error_quantile(const ContourSpread& spread, double share);

}  // namespace feedscope::ui
