#pragma once

#include <QString>
#include <QValueAxis>

#include "ui/charts/value_fit.h"

namespace feedscope::ui {

/// Shows a range on an axis with round values at two to `most` ticks. Where they would be less than `closest`
/// apart and lose labels, the two farthest apart remain.
void show_range(QValueAxis* axis, const Interval& range, int most, double closest = 0);
/// The label of a tick at this value.
QString tick_text(const QValueAxis& axis, double value);

}  // namespace feedscope::ui
