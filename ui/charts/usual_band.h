#pragma once

#include <QColor>
#include <QRectF>
#include <span>

#include "ui/charts/curve_columns.h"

namespace feedscope::ui {

enum class BandFill { none, pale };

/// Draws the usual range of a curve along stretches of `columns` columns each, of `count` in the plot: two
/// edges of width `edge` [px], and where it is filled a pale band between them. Empty spans are gaps.
void draw_usual_band(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> stretches,
                     std::size_t columns, std::size_t count, const QColor& colour, double edge,
                     BandFill fill);

/// Whether the usual range shows more of a curve than its columns: bars hide the curve, or rare peaks make
/// columns at least twice as high as the usual range.
bool says_more(std::span<const ColumnSpan> usual, std::span<const ColumnSpan> columns);

}  // namespace feedscope::ui
