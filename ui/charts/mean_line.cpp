#include "ui/charts/mean_line.h"

#include <QPainter>
#include <cmath>

namespace feedscope::ui {

std::vector<float> mean_feeds(const Trajectory& trajectory, std::span<const double> times) {
  std::vector<float> means;
  if (times.size() < 2 || trajectory.pieces().empty()) {
    return means;
  }
  means.reserve(times.size() - 1);
  double from = trajectory.state(times.front()).path_length;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double to = trajectory.state(times[i]).path_length;
    const double time = times[i] - times[i - 1];
    means.push_back(static_cast<float>(time > 0 ? (to - from) / time : 0));
    from = to;
  }
  return means;
}

std::vector<QPolygonF> mean_lines(const QRectF& plot, std::span<const ColumnSpan> columns,
                                  std::span<const float> means,
                                  const std::function<double(double)>& height_of) {
  constexpr qsizetype least_columns = 12;
  constexpr double high = 10;  // [px]
  std::vector<QPolygonF> lines;
  if (columns.size() != means.size() || columns.empty()) {
    return lines;
  }
  const double width = plot.width() / static_cast<double>(columns.size());
  QPolygonF line;
  for (std::size_t i = 0; i <= columns.size(); ++i) {
    const bool dense =
        i < columns.size() && !columns[i].empty() && columns[i].height() > high && std::isfinite(means[i]);
    if (dense) {
      line.append({plot.left() + (static_cast<double>(i) + 0.5) * width, height_of(double{means[i]})});
      continue;
    }
    if (line.size() >= least_columns) {
      lines.push_back(line);
    }
    line.clear();
  }
  return lines;
}

void draw_mean_lines(QPainter& painter, const std::vector<QPolygonF>& lines, const QColor& colour,
                     QColor behind) {
  constexpr double width = 1.6;
  constexpr double halo = 4;
  constexpr int halo_opacity = 200;
  behind.setAlpha(halo_opacity);
  for (const QPolygonF& line : lines) {
    for (const QPen& pen : {QPen(behind, halo), QPen(colour, width)}) {
      painter.setPen(QPen(pen.color(), pen.widthF(), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
      painter.drawPolyline(line);
    }
  }
}

}  // namespace feedscope::ui
