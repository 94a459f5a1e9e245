#pragma once

#include "ui/report/report_input.h"

namespace feedscope::ui {

/// How well the current run agrees with what the control recorded, a part for each trace: verdict, figures,
/// the places that differ most, what is to be known of the trace. Empty without traces.
QString traces_block(const ReportInput& input);

}  // namespace feedscope::ui
