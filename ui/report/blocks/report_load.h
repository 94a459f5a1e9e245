#pragma once

#include <QString>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of a report on the cutting load of the current run, as HTML; empty without operations.

/// Engagement of the tools, largest and mean loads compared with those at the programmed feed, exceeded
/// bounds, and assumptions.
QString load_block(const ReportInput& input);
/// The path coloured by chip thickness.
QString load_view_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
