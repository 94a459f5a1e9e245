#include "ui/shared/plot_grid.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <cmath>

namespace feedscope::ui {

namespace {

constexpr double label_gap = 4;  // between labels side by side [pixels]

double on_pixel(double place) {
  return std::round(place) + 0.5;
}

}  // namespace

PlotGrid::PlotGrid(QPainter& painter, const QRectF& plot, GridLook look)
    : painter_(painter), plot_(plot), look_(look) {}

void PlotGrid::level(double y, const QString& label, GridLine line) {
  const double at = on_pixel(y);
  painter_.setPen(QPen(line == GridLine::strong ? look_.strong : look_.grid, 1));
  painter_.drawLine(QPointF(plot_.left(), at), QPointF(plot_.right(), at));
  const QFontMetricsF metrics(painter_.font());
  const double room = metrics.horizontalAdvance(label) + label_gap;
  draw_label({plot_.left() - look_.beside - room, at - metrics.height() / 2, room, metrics.height()},
             Qt::AlignRight, label, last_beside_);
}

void PlotGrid::upright(double x, const QString& label, GridLine line) {
  const double at = on_pixel(x);
  painter_.setPen(QPen(line == GridLine::strong ? look_.strong : look_.grid, 1));
  if (!shared_.isNull()) {
    painter_.drawLine(QPointF(at, shared_.top()), QPointF(at, shared_.bottom()));
  }
  painter_.drawLine(QPointF(at, plot_.top()), QPointF(at, plot_.bottom() + look_.tick));
  const QFontMetricsF metrics(painter_.font());
  const double room = metrics.horizontalAdvance(label) + label_gap;
  draw_label({at - room / 2, plot_.bottom() + look_.below, room, metrics.height()}, Qt::AlignHCenter, label,
             last_below_);
}

void PlotGrid::draw_label(const QRectF& place, Qt::Alignment side, const QString& label, QRectF& last) {
  if (!label.isEmpty() && !place.intersects(last)) {
    painter_.setPen(look_.text);
    painter_.drawText(place, side | Qt::AlignVCenter, label);
    last = place;
  }
}

QString tick_text(const Ticks& ticks, std::size_t i) {
  const auto decimals = QString::fromStdString(ticks.labels[i]).section('.', 1).size();
  return QLocale().toString(ticks.values[i], 'f', static_cast<int>(decimals)).replace('-', QChar(0x2212));
}

std::vector<QRectF> entries_in_rows(std::span<const double> widths, const QRectF& area, double line,
                                    double row, double gap) {
  std::vector<QRectF> entries;
  double x = area.left();
  double y = area.top();
  for (const double width : widths) {
    if (x > area.left() && x + width > area.right()) {
      x = area.left();
      y += row;
    }
    entries.emplace_back(x, y, width, line);
    x += width + gap;
  }
  return entries;
}

}  // namespace feedscope::ui
