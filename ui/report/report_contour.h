#pragma once

#include <QString>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of a report about the contour error, as HTML; empty if the current run follows the path exactly. The
// input has its contour reports.

/// How much of the path has which error, all runs in one picture.
QString contour_histogram_block(const ReportInput& input, ReportPictures& pictures);
/// Where the current run is farthest from the programmed path; places that are similar stand together.
QString contour_places_block(const ReportInput& input);
/// Close-ups of the same places, the deviation enlarged.
QString contour_place_views_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
