#pragma once

#include <QString>

#include "ui/charts/value_fit.h"

namespace feedscope::ui {

/// A round step with two to `most` ticks in the range; where they would be less than `closest` apart and lose
/// labels, the step between the two farthest apart.
double tick_step(const Interval& range, int most, double closest = 0);
/// The label of a multiple of `step`. `largest` on the axis: from a million on, it has four digits, for
/// which there is room next to a plot.
QString tick_text(double value, double step, double largest = 0);

}  // namespace feedscope::ui
