#pragma once

#include <QString>

#include "core/analysis/run.h"

namespace feedscope::ui {

/// How many errors and warnings the reading of a program has, for every picture of it: "Program read with 2
/// errors and 1 warning". Empty where there is none; notes do not count.
QString reading_faults_text(const Program& program);

/// "Not in the cycle time: 2 tool changes, 1 spindle start"; empty where all time is counted.
QString not_counted_text(const NotCounted& counts);

}  // namespace feedscope::ui
