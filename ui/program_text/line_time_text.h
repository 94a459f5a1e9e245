#pragma once

#include <QString>

#include "core/analysis/time/line_times.h"

namespace feedscope::ui {

/// Heat of a line of duration `time` if the slowest line takes `largest`, 0 to 1: the cube root of the ratio,
/// so that a factor of two is visible, and short lines are too when there is a long dwell.
double heat_of(double time, double largest);

/// Cost of the lines from `first` to `last`: time and share, number of runs, mean feed. Several lines of
/// text; empty for lines without time.
QString line_time_text(const LineTimes& times, std::uint32_t first, std::uint32_t last);

}  // namespace feedscope::ui
