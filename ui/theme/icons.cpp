#include "ui/theme/icons.h"

#include <QGuiApplication>
#include <QIconEngine>
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

/// Lines in a square of `side`.
QPainterPath lines_of(DockIcon kind) {
  QPainterPath path;
  if (kind == DockIcon::close) {
    path.moveTo(3, 3);
    path.lineTo(side - 3, side - 3);
    path.moveTo(side - 3, 3);
    path.lineTo(3, side - 3);
  } else {
    path.addRect(2, 6, 8, 8);
    path.moveTo(6, 5);
    path.lineTo(6, 2);
    path.lineTo(14, 2);
    path.lineTo(14, 10);
    path.lineTo(11, 10);
  }
  return path;
}

class DockIconEngine : public QIconEngine {
 public:
  explicit DockIconEngine(DockIcon kind) : kind_(kind) {}

  void paint(QPainter* painter, const QRect& place, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(place.topLeft());
    painter->scale(place.width() / double(side), place.height() / double(side));
    constexpr double line_width = 1.6;
    painter->setPen(QPen(QGuiApplication::palette().color(group, QPalette::WindowText), line_width));
    painter->drawPath(lines_of(kind_));
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect({}, size), mode, state);
    return pixmap;
  }
  QSize actualSize(const QSize& size, QIcon::Mode, QIcon::State) override {
    constexpr int suits_a_title = 12;
    return size.boundedTo({suits_a_title, suits_a_title});
  }
  QIconEngine* clone() const override { return new DockIconEngine(kind_); }

 private:
  DockIcon kind_;
};

}  // namespace

QIcon dock_icon(DockIcon kind) {
  return QIcon(new DockIconEngine(kind));
}

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
