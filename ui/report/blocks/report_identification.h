#pragma once

#include <QString>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of a report on identification results, as HTML; empty without a result.

/// Recordings, agreement of the models, and for the chosen model its numbers: value, uncertainty and source,
/// or the reason why it is not identifiable and what would make it so.
QString identification_block(const ReportInput& input);
/// Residuals of the models as curves over the time of the recordings, or bars by section.
QString identification_charts_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
