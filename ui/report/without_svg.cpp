#include <QSizeF>

#include "core/base/error.h"
#include "ui/report/svg_picture.h"

namespace feedscope::ui {

QSizeF svg_size(const QByteArray&) {
  throw InputError(NC_("core", "is an SVG file, which this build of Feedscope cannot draw; use PNG or JPEG"));
}

void draw_svg(QPainter&, const QByteArray&, const QRectF&) {}

}  // namespace feedscope::ui
