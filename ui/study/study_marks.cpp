#include "ui/study/study_marks.h"

#include <QPolygonF>
#include <QRectF>
#include <array>

#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

using Hues = std::array<QColor, 7>;
constexpr Hues light_hues{QColor(0x00, 0x72, 0xb2), QColor(0xd5, 0x5e, 0x00), QColor(0x00, 0x9e, 0x73),
                          QColor(0xcc, 0x79, 0xa7), QColor(0xb0, 0x83, 0x00), QColor(0x3a, 0x95, 0xc8),
                          QColor(0x00, 0x00, 0x00)};
constexpr Hues dark_hues{QColor(0x56, 0xb4, 0xe9), QColor(0xff, 0x8a, 0x3d), QColor(0x2f, 0xc9, 0x9b),
                         QColor(0xe8, 0xa3, 0xc9), QColor(0xf0, 0xb4, 0x2e), QColor(0x9f, 0xd6, 0xf5),
                         QColor(0xf0, 0xf0, 0xf0)};

}  // namespace

QColor study_hue(std::size_t curve, const QPalette& palette) {
  const Hues& hues = theme_of(palette) == ThemeKind::dark ? dark_hues : light_hues;
  return hues[curve % hues.size()];
}

QPainterPath study_marker(std::size_t curve, const QPointF& at, double radius) {
  QPainterPath path;
  switch (curve % 4) {
    case 0:
      path.addEllipse(at, radius, radius);
      break;
    case 1:
      path.addRect(
          QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius).adjusted(0.5, 0.5, -0.5, -0.5));
      break;
    case 2:
      path.addPolygon(QPolygonF({at + QPointF(0, -radius * 1.2), at + QPointF(radius * 1.1, radius * 0.8),
                                 at + QPointF(-radius * 1.1, radius * 0.8)}));
      path.closeSubpath();
      break;
    default:
      path.addPolygon(QPolygonF({at + QPointF(0, -radius * 1.3), at + QPointF(radius * 1.3, 0),
                                 at + QPointF(0, radius * 1.3), at + QPointF(-radius * 1.3, 0)}));
      path.closeSubpath();
  }
  return path;
}

}  // namespace feedscope::ui
