#pragma once

#include <QValueAxis>

#include "ui/charts/value_fit.h"

namespace feedscope::ui {

/// Shows a range on an axis with round values at `most` ticks at most, but at two at least. Where these would
/// be less than `closest` apart, so that labels were left out, the two that are farthest apart have them.
void show_range(QValueAxis* axis, const Interval& range, int most, double closest = 0);

}  // namespace feedscope::ui
