#pragma once

#include <QColor>
#include <QRectF>
#include <span>

#include "ui/charts/curve_columns.h"

namespace feedscope::ui {

/// Draws where a curve usually is along stretches of `columns` columns each, of which the plot has `count`:
/// a pale band between two edges. Empty spans are gaps.
void draw_usual_band(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> stretches,
                     std::size_t columns, std::size_t count, const QColor& colour);

}  // namespace feedscope::ui
