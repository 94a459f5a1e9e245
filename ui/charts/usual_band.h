#pragma once

#include <QColor>
#include <QRectF>
#include <span>

#include "ui/charts/curve_columns.h"

namespace feedscope::ui {

enum class BandFill { none, pale };

/// Draws where a curve usually is along stretches of `columns` columns each, of which the plot has `count`:
/// two edges, which are `edge` wide [px], and between them a pale band where it is to be filled. Empty spans
/// are gaps.
void draw_usual_band(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> stretches,
                     std::size_t columns, std::size_t count, const QColor& colour, double edge,
                     BandFill fill);

/// Whether that says more of a curve than its columns: bars hide the curve, or rare peaks take most of the
/// ink, as columns are twice as high as what is usual and more.
bool says_more(std::span<const ColumnSpan> usual, std::span<const ColumnSpan> columns);

}  // namespace feedscope::ui
