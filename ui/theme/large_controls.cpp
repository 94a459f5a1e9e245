#include "ui/theme/large_controls.h"

#include <QColor>
#include <QPainter>
#include <QPolygonF>
#include <QStyleOptionComplex>
#include <algorithm>

#include "ui/theme/type_size.h"

namespace feedscope::ui {
namespace {

constexpr int list_arrow_room = 19;  // [px], as in Fusion
constexpr int number_arrow_room = 14;
constexpr int groove = 7;

bool is_large() {
  return TypeSize::of_application().scale() > 1;
}

int more_than_usual(int usual) {
  return type_pixels(usual) - usual;
}

}  // namespace

std::optional<Qt::ArrowType> large_arrow(QStyle::PrimitiveElement element, const QStyleOption& option) {
  if (!is_large()) {
    return std::nullopt;
  }
  switch (element) {
    case QStyle::PE_IndicatorArrowUp:
      return Qt::UpArrow;
    case QStyle::PE_IndicatorArrowDown:
      return Qt::DownArrow;
    case QStyle::PE_IndicatorArrowLeft:
      return Qt::LeftArrow;
    case QStyle::PE_IndicatorArrowRight:
      return Qt::RightArrow;
    case QStyle::PE_IndicatorBranch:
      return !option.state.testFlag(QStyle::State_Children) ? Qt::NoArrow
             : option.state.testFlag(QStyle::State_Open)    ? Qt::DownArrow
                                                            : Qt::RightArrow;
    default:
      return std::nullopt;
  }
}

void draw_large_arrow(QPainter& painter, const QRect& room, Qt::ArrowType arrow, const QColor& colour) {
  constexpr double usual_side = 8;  // [px]
  const double side = std::min({line_pixels(usual_side), double(room.width()), double(room.height())});
  const double angle = arrow == Qt::UpArrow      ? 180
                       : arrow == Qt::LeftArrow  ? 90
                       : arrow == Qt::RightArrow ? -90
                                                 : 0;
  if (arrow == Qt::NoArrow) {
    return;
  }
  const QPolygonF down{{-side / 2, -side / 4}, {side / 2, -side / 4}, {0, side / 4}};
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(QRectF(room).center());
  painter.rotate(angle);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawPolygon(down);
  painter.restore();
}

void draw_large_arrows(const QStyle& style, QStyle::ComplexControl control, const QStyleOptionComplex& option,
                       QPainter& painter, const QWidget* widget) {
  const auto draw = [&](QStyle::SubControl part, Qt::ArrowType arrow) {
    draw_large_arrow(painter, style.subControlRect(control, &option, part, widget), arrow,
                     option.palette.color(QPalette::ButtonText));
  };
  if (!is_large()) {
    return;
  }
  if (control == QStyle::CC_ComboBox) {
    draw(QStyle::SC_ComboBoxArrow, Qt::DownArrow);
  } else if (control == QStyle::CC_SpinBox) {
    draw(QStyle::SC_SpinBoxUp, Qt::UpArrow);
    draw(QStyle::SC_SpinBoxDown, Qt::DownArrow);
  }
}

QRect large_part(QStyle::ComplexControl control, QStyle::SubControl part, QRect usual, const QRect& whole) {
  if (!is_large() || usual.isEmpty()) {
    return usual;
  }
  if (control == QStyle::CC_ComboBox && part == QStyle::SC_ComboBoxArrow) {
    usual.setLeft(usual.right() - type_pixels(list_arrow_room) + 1);
  } else if (control == QStyle::CC_ComboBox && part == QStyle::SC_ComboBoxEditField) {
    usual.setRight(usual.right() - more_than_usual(list_arrow_room));
  } else if (control == QStyle::CC_SpinBox &&
             (part == QStyle::SC_SpinBoxUp || part == QStyle::SC_SpinBoxDown)) {
    usual.setLeft(usual.right() - type_pixels(number_arrow_room) + 1);
  } else if (control == QStyle::CC_SpinBox && part == QStyle::SC_SpinBoxEditField) {
    usual.setRight(usual.right() - more_than_usual(number_arrow_room));
  } else if (control == QStyle::CC_Slider && part == QStyle::SC_SliderGroove &&
             whole.width() > whole.height()) {
    const int height = type_pixels(groove);
    usual.setTop(usual.center().y() - height / 2);
    usual.setHeight(height);
  }
  return usual;
}

int room_of_large_arrows(QStyle::ContentsType type) {
  return type == QStyle::CT_ComboBox  ? more_than_usual(list_arrow_room)
         : type == QStyle::CT_SpinBox ? more_than_usual(number_arrow_room)
                                      : 0;
}

}  // namespace feedscope::ui
