#pragma once

#include <QString>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of a report on the full circles of the program, as HTML; empty without circles. The input contains
// its circles.

/// `input` with the circles of the current run. Throws Cancelled if `progress` is cancelled.
ReportInput with_circles(ReportInput input, Progress* progress = nullptr);

/// Values of each circle by ISO 230-4, their meaning, and the circles that are not evaluated.
QString circles_block(const ReportInput& input);
/// Polar plots of the first circles.
QString circle_plots_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
