#pragma once

#include <QColor>
#include <QPainterPath>
#include <QPalette>
#include <QPointF>
#include <cstddef>

namespace feedscope::ui {

/// Hue of curve number `curve` of a study, from 0: those of Okabe and Ito that contrast with the palette's
/// plot.
QColor study_hue(std::size_t curve, const QPalette& palette);
/// Round, square, triangle, diamond: curves differ in shape as well as in colour.
QPainterPath study_marker(std::size_t curve, const QPointF& at, double radius);

}  // namespace feedscope::ui
