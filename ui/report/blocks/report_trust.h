#pragma once

#include <QString>

#include "ui/report/report_input.h"

namespace feedscope::ui {

/// Machine, settings, models and trust in two columns: limits of the machines, settings that differ from
/// their files, a line for each model, program, notes on the runs, effects that are not modelled and times
/// that are not counted.
QString trust_block(const ReportInput& input);

}  // namespace feedscope::ui
