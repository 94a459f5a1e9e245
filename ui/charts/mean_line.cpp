#include "ui/charts/mean_line.h"

#include <QPaintEngine>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope::ui {

std::vector<float> mean_feeds(const Trajectory& trajectory, std::span<const ColumnStretch> stretches,
                              std::size_t count) {
  std::vector<double> lengths(count);
  std::vector<double> times(count);
  double end = -1;  // of the last stretch, where the next one often begins [s]
  double reached = 0;
  for (const ColumnStretch& stretch : stretches) {
    const double from = stretch.from == end ? reached : trajectory.state(stretch.from).path_length;
    end = stretch.to;
    reached = trajectory.state(end).path_length;
    lengths[stretch.column] += reached - from;
    times[stretch.column] += end - stretch.from;
  }
  std::vector<float> means(count);
  for (std::size_t i = 0; i < count; ++i) {
    means[i] =
        times[i] > 0 ? static_cast<float>(lengths[i] / times[i]) : std::numeric_limits<float>::quiet_NaN();
  }
  return means;
}

std::vector<QPolygonF> mean_lines(const QRectF& plot, std::span<const ColumnSpan> columns,
                                  std::span<const float> means,
                                  const std::function<double(double)>& height_of, bool everywhere) {
  constexpr qsizetype least_columns = 12;
  constexpr double high = 10;  // [px]
  std::vector<QPolygonF> lines;
  if (columns.size() != means.size() || columns.empty()) {
    return lines;
  }
  const double width = plot.width() / static_cast<double>(columns.size());
  QPolygonF line;
  for (std::size_t i = 0; i <= columns.size(); ++i) {
    const bool dense = i < columns.size() && !columns[i].empty() &&
                       (everywhere || columns[i].height() > high) && std::isfinite(means[i]);
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

namespace {

/// Draws the same pixels in strips: for a line that goes up and down in every column, the work of the raster
/// engine grows with the square of the columns. `reach`: of the pen to either side [px].
void draw_in_strips(QPainter& painter, const QPolygonF& line, double reach) {
  constexpr qsizetype points_a_strip = 48;
  const auto pixel = [&](qsizetype point) { return static_cast<int>(std::floor(line[point].x())); };
  const auto whole = static_cast<int>(std::ceil(reach));
  const QRect around = line.boundingRect().toAlignedRect().adjusted(-whole, -whole, whole, whole);
  const qsizetype last = line.size() - 1;
  for (qsizetype first = 0, end = 0; first < last; first = end) {
    end = std::min(first + points_a_strip, last);
    qsizetype from = first;
    qsizetype to = end;
    while (from > 0 && line[from].x() > line[first].x() - reach - 1) {
      --from;
    }
    while (to < last && line[to].x() < line[end].x() + reach + 1) {
      ++to;
    }
    painter.save();
    painter.setClipRect(QRect(QPoint(first == 0 ? around.left() : pixel(first), around.top()),
                              QPoint(end == last ? around.right() : pixel(end) - 1, around.bottom())),
                        Qt::IntersectClip);
    painter.drawPolyline(line.constData() + from, static_cast<int>(to - from + 1));
    painter.restore();
  }
}

}  // namespace

void draw_mean_lines(QPainter& painter, const std::vector<QPolygonF>& lines, const QColor& colour,
                     QColor behind, double scale) {
  constexpr double width = 1.6;
  constexpr double halo = 4;
  constexpr int halo_opacity = 200;
  behind.setAlpha(halo_opacity);
  for (const QPolygonF& line : lines) {
    for (const QPen& pen : {QPen(behind, scale * halo), QPen(colour, scale * width)}) {
      painter.setPen(QPen(pen.color(), pen.widthF(), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
      if (painter.paintEngine()->type() == QPaintEngine::Raster) {
        draw_in_strips(painter, line, pen.widthF());
      } else {
        painter.drawPolyline(line);
      }
    }
  }
}

}  // namespace feedscope::ui
