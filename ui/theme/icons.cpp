#include "ui/theme/icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>
#include <utility>

#include "ui/theme/type_size.h"

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
  } else if (kind == DockIcon::more || kind == DockIcon::more_below) {
    for (const double left : {4.0, 8.5}) {
      path.moveTo(left, 4.5);
      path.lineTo(left + 3.5, 8);
      path.lineTo(left, 11.5);
    }
    return kind == DockIcon::more ? path : QTransform(0, 1, 1, 0, 0, 0).map(path);
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

QPainterPath lines_of(EditIcon kind) {
  QPainterPath path;
  path.moveTo(6, 2);
  path.lineTo(2, 6);
  path.lineTo(6, 10);
  path.moveTo(2, 6);
  path.lineTo(10, 6);
  path.arcTo(QRectF(6, 6, 8, 8), 90, -180);
  path.lineTo(6, 14);
  return kind == EditIcon::undo ? path : QTransform(-1, 0, 0, 1, side, 0).map(path);
}

/// Lines in the colour of texts at the time of painting, at most `largest` pixels high at the usual font
/// size.
class LineIconEngine : public QIconEngine {
 public:
  LineIconEngine(QPainterPath lines, int largest) : lines_(std::move(lines)), largest_(largest) {}

  void paint(QPainter* painter, const QRect& place, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(place.topLeft());
    painter->scale(place.width() / double(side), place.height() / double(side));
    constexpr double line_width = 1.6;
    painter->setPen(QPen(QGuiApplication::palette().color(group, QPalette::WindowText), line_width));
    painter->drawPath(lines_);
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
    const int largest = type_pixels(largest_);
    return size.boundedTo({largest, largest});
  }
  QIconEngine* clone() const override { return new LineIconEngine(lines_, largest_); }

 private:
  QPainterPath lines_;
  int largest_;
};

}  // namespace

QIcon dock_icon(DockIcon kind) {
  constexpr int suits_a_title = 12;
  return QIcon(new LineIconEngine(lines_of(kind), suits_a_title));
}

QIcon edit_icon(EditIcon kind) {
  constexpr int suits_a_bar = 20;
  return QIcon(new LineIconEngine(lines_of(kind), suits_a_bar));
}

QIcon media_icon(MediaIcon kind, const QPalette& palette) {
  QIcon icon;
  for (const int scale : {1, 2, 3, 4, 6, 8}) {  // of the pixels of a screen, and of the font size
    QPixmap pixmap(side * scale, side * scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    painter.fillPath(outline(kind), palette.color(QPalette::ButtonText));
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

}  // namespace feedscope::ui
