#pragma once

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of the page on motion.

/// Feed of all runs over the path length of feed motions on one scale, the time lost below.
QString feed_course_block(const ReportInput& input, ReportPictures& pictures);
/// Feed, acceleration and jerk of all runs about the three places of the current one that lose most.
QString motion_windows_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
