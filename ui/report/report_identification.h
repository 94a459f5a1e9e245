#pragma once

#include <QString>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of a report about what was identified, as HTML; empty without a result.

/// Recordings, how well the models explain them, and of the chosen model its numbers: value, uncertainty and
/// where it is from, or why it is not told and what would tell it.
QString identification_block(const ReportInput& input);
/// What the models leave over of the recordings, as curves over their time or bars by section.
QString identification_charts_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
