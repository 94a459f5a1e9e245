#pragma once

#include <QString>

#include "ui/report/report_input.h"

namespace feedscope::ui {

/// Machine, settings, models and trust in two columns: limits of the machines, settings that differ from
/// their files, a line a model, program, notes on the runs, what is not modelled and not counted.
QString trust_block(const ReportInput& input);

}  // namespace feedscope::ui
