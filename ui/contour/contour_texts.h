#pragma once

#include <QString>

#include "core/analysis/contour/contour_report.h"

namespace feedscope::ui {

// Texts on contour errors for the screen; numbers by the locale and the unit system.

/// "28.3", with one digit more below 10 µm and two below 1 µm.
QString error_text(double mm);
/// "28.3 µm".
QString error_amount_text(double mm);
/// "12 (N120)".
QString line_text(const ContourFinding& finding);
/// "left", "right"; "–" if the deviation is not in XY.
QString side_text(const ContourPlace& place);
/// "Corner of 90°, inside", "Arc R 5 mm, inside", "Line of 0.2 mm".
QString spot_text(const ContourSpot& spot);
/// The largest error, its place, time and tolerance, in one or two sentences.
QString verdict_text(const ContourReport& report);
/// The share of the path with almost no error. `sides`: where left and right are shown, adds a largest error
/// that is on neither side.
QString share_text(const ContourReport& report, bool sides);

/// The error that the path exceeds on at most a `share` of its length [mm], to the resolution of the spread.
double error_quantile(const ContourSpread& spread, double share);

}  // namespace feedscope::ui
