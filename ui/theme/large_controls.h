#pragma once

#include <QRect>
#include <QStyle>
#include <optional>

class QColor;
class QPainter;
class QStyleOption;
class QStyleOptionComplex;

namespace feedscope::ui {

/// Controls that Fusion draws in a fixed number of pixels, scaled with the font: arrows of lists, numbers,
/// trees and menus, and the groove of sliders. At the usual font size nothing changes.

/// The arrow of an element; none: another element, or the usual font size.
std::optional<Qt::ArrowType> large_arrow(QStyle::PrimitiveElement element, const QStyleOption& option);
/// At the centre of `room`.
void draw_large_arrow(QPainter& painter, const QRect& room, Qt::ArrowType arrow, const QColor& colour);
/// Draws them over the arrows of `control`.
void draw_large_arrows(const QStyle& style, QStyle::ComplexControl control, const QStyleOptionComplex& option,
                       QPainter& painter, const QWidget* widget);
/// Place of a part of a control in `whole`; `usual`: at the usual font size.
QRect large_part(QStyle::ComplexControl control, QStyle::SubControl part, QRect usual, const QRect& whole);
/// Additional width for the arrows of a control [px].
int room_of_large_arrows(QStyle::ContentsType type);

}  // namespace feedscope::ui
