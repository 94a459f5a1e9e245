#pragma once

class QByteArray;
class QPainter;
class QRectF;
class QSizeF;

namespace feedscope::ui {

// Drawings of the user in SVG: by Qt SVG (with_svg.cpp), or refused by a build without it (without_svg.cpp).

/// The preferred size [1/96 inch]; empty if the bytes are no SVG. Throws InputError, without the file's name,
/// in a build without Qt SVG.
QSizeF svg_size(const QByteArray& bytes);
void draw_svg(QPainter& painter, const QByteArray& bytes, const QRectF& place);

}  // namespace feedscope::ui
