#pragma once

#include <QPolygonF>
#include <functional>
#include <span>
#include <vector>

#include "core/analysis/time/rapid_times.h"
#include "core/trajectory/trajectory.h"
#include "ui/charts/curve_columns.h"

namespace feedscope::ui {

/// Path length over time of the stretches in each of `count` columns [mm/s]; NaN without a stretch.
std::vector<float> mean_feeds(const Trajectory& trajectory, std::span<const ColumnStretch> stretches,
                              std::size_t count);

/// Mean lines along columns so high that they show only the extremes, over stretches of a dozen columns or
/// more.
///
/// `columns`: of the curve over `plot`'s width [px]; `means`: a value for each, NaN where there is none;
/// `height_of`: position of a value [px]; `everywhere`: along low columns, too. Empty if the numbers of
/// columns and means differ.
std::vector<QPolygonF> mean_lines(const QRectF& plot, std::span<const ColumnSpan> columns,
                                  std::span<const float> means,
                                  const std::function<double(double)>& height_of, bool everywhere = false);

/// Draws the lines so that they contrast with the columns. `behind`: colour of the plot; `scale`: of the
/// width of lines.
void draw_mean_lines(QPainter& painter, const std::vector<QPolygonF>& lines, const QColor& colour,
                     QColor behind, double scale);

}  // namespace feedscope::ui
