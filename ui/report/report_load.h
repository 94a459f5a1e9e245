#pragma once

#include <QString>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Blocks of a report about the cutting load of the current run, as HTML; empty where no operations are known.

/// How the tools are engaged, largest and mean loads against those of the programmed feed, what is beyond a
/// bound, and what is assumed.
QString load_block(const ReportInput& input);
/// The path coloured by chip thickness.
QString load_view_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
