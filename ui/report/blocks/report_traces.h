#pragma once

#include "ui/report/report_input.h"

namespace feedscope::ui {

/// Agreement of the current run with the recordings, a part for each trace: verdict, figures, the places with
/// the largest differences, notes on the trace. Empty without traces.
QString traces_block(const ReportInput& input);

}  // namespace feedscope::ui
