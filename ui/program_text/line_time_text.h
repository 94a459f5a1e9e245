#pragma once

#include <QString>

#include "core/analysis/line_times.h"

namespace feedscope::ui {

/// How hot a line is drawn that takes `time` where the slowest takes `largest`, 0 to 1: the cube root of the
/// ratio, so that lines which differ by two are told apart and short ones are seen beside a long dwell.
double heat_of(double time, double largest);

/// What the lines from `first` to `last` cost: time and share, how often they ran, mean feed. Several lines
/// of text; empty for lines that take no time.
QString line_time_text(const LineTimes& times, std::uint32_t first, std::uint32_t last);

}  // namespace feedscope::ui
