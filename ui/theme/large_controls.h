#pragma once

#include <QRect>
#include <QStyle>
#include <optional>

class QColor;
class QPainter;
class QStyleOption;
class QStyleOptionComplex;

namespace feedscope::ui {

/// What Fusion draws in a fixed number of pixels, as large as the type is: arrows of lists, numbers, trees
/// and menus, and the groove of sliders. At the usual size of type none of this changes anything.

/// Which arrow an element is; none: another element, or type of the usual size.
std::optional<Qt::ArrowType> large_arrow(QStyle::PrimitiveElement element, const QStyleOption& option);
/// In the middle of `room`.
void draw_large_arrow(QPainter& painter, const QRect& room, Qt::ArrowType arrow, const QColor& colour);
/// Over those that `control` was drawn with.
void draw_large_arrows(const QStyle& style, QStyle::ComplexControl control, const QStyleOptionComplex& option,
                       QPainter& painter, const QWidget* widget);
/// Where a part of a control is, `usual` being its place at the usual size of type, in a control in `whole`.
QRect large_part(QStyle::ComplexControl control, QStyle::SubControl part, QRect usual, const QRect& whole);
/// What the arrows of a control need beyond their usual width [px].
int room_of_large_arrows(QStyle::ContentsType type);

}  // namespace feedscope::ui
