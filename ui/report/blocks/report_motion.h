#pragma once

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of the page on motion.

/// Feed of all runs over the path length of feed motions on one scale, with the time lost below.
QString feed_course_block(const ReportInput& input, ReportPictures& pictures);
/// Feed, acceleration and jerk of all runs around the three places with the largest losses of the current
/// one.
QString motion_windows_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
