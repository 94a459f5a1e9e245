#pragma once

#include <QColor>
#include <QRectF>
#include <span>

#include "ui/charts/curve_columns.h"

namespace feedscope::ui {

/// Draws where a curve usually is along stretches of `columns` columns each, of which the plot has `count`:
/// a pale band between two edges, which are `edge` wide [px]. Empty spans are gaps.
void draw_usual_band(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> stretches,
                     std::size_t columns, std::size_t count, const QColor& colour, double edge);

/// Whether that says more of a curve than its columns: bars hide the curve, or rare peaks take most of the
/// ink, as columns are twice as high as what is usual and more.
bool says_more(std::span<const ColumnSpan> usual, std::span<const ColumnSpan> columns);

}  // namespace feedscope::ui
