#include <QSvgRenderer>

#include "ui/report/svg_picture.h"

namespace feedscope::ui {

QSizeF svg_size(const QByteArray& bytes) {
  return QSvgRenderer(bytes).defaultSize();
}

void draw_svg(QPainter& painter, const QByteArray& bytes, const QRectF& place) {
  QSvgRenderer(bytes).render(&painter, place);
}

}  // namespace feedscope::ui
