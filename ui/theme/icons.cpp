#include "ui/theme/icons.h"

#include <QPainter>
#include <QPainterPath>

namespace feedscope::ui {

namespace {

constexpr int side = 16;
constexpr double bar_width = 3;

QPolygonF triangle(double from, double to) {
  return {QPointF(from, 2), QPointF(to, side / 2.0), QPointF(from, side - 2)};
}

QPainterPath outline(MediaIcon kind) {
  QPainterPath path;
  const auto bar = [&path](double left) { path.addRect(left, 2, bar_width, side - 4); };
  switch (kind) {
    case MediaIcon::play:
      path.addPolygon(triangle(3, 14));
      break;
    case MediaIcon::pause:
      bar(3);
      bar(side - 3 - bar_width);
      break;
    case MediaIcon::back:
      bar(2);
      path.addPolygon(triangle(14, 5));
      break;
    case MediaIcon::on:
      path.addPolygon(triangle(2, 11));
      bar(side - 2 - bar_width);
      break;
  }
  return path;
}

}  // namespace

QIcon media_icon(MediaIcon kind, const QPalette& palette) {
  QIcon icon;
  for (const int scale : {1, 2}) {
    QPixmap pixmap(side * scale, side * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(outline(kind), palette.color(QPalette::ButtonText));
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

}  // namespace feedscope::ui
