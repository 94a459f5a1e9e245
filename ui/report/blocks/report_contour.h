#pragma once

#include <QString>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of a report on the contour error, as HTML; empty if the current run follows the path exactly. The
// input contains its contour reports.

/// Distribution of the error over the path, for all runs in one picture.
QString contour_histogram_block(const ReportInput& input, ReportPictures& pictures);
/// Places of the current run with the largest contour errors; similar ones are grouped.
QString contour_places_block(const ReportInput& input);
/// Close-ups of the same places, with enlarged deviation.
QString contour_place_views_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
