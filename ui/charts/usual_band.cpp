#include "ui/charts/usual_band.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>

namespace feedscope::ui {

void draw_usual_band(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> stretches,
                     std::size_t columns, std::size_t count, const QColor& colour, double edge,
                     BandFill fill) {
  constexpr int inside_opacity = 90;
  if (count == 0) {
    return;
  }
  const double width = plot.width() / static_cast<double>(count);
  QColor inside = colour;
  inside.setAlpha(inside_opacity);
  const auto x_of = [&](std::size_t stretch) {
    return plot.left() + width * static_cast<double>(std::min(stretch * columns, count));
  };
  for (std::size_t first = 0; first < stretches.size();) {
    std::size_t end = first;
    QPolygonF upper;
    QPolygonF lower;
    for (; end < stretches.size() && !stretches[end].empty(); ++end) {
      for (const double x : {x_of(end), x_of(end + 1)}) {
        upper.append({x, stretches[end].top});
        lower.prepend({x, stretches[end].bottom});
      }
    }
    if (end > first) {
      if (fill == BandFill::pale) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(inside);
        painter.drawPolygon(upper + lower);
        painter.setBrush(Qt::NoBrush);
      }
      painter.setPen(QPen(colour, edge, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
      painter.drawPolyline(upper);
      painter.drawPolyline(lower);
    }
    first = end + 1;
  }
}

bool says_more(std::span<const ColumnSpan> usual, std::span<const ColumnSpan> columns) {
  constexpr double least_peaks = 4;  // [px]
  constexpr double many_times = 2;
  return hidden_in_bars(columns) ||
         mean_height(columns) > std::max(least_peaks, many_times * mean_height(usual));
}

}  // namespace feedscope::ui
