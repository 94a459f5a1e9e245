#pragma once

#include <QColor>
#include <QPainterPath>
#include <QPalette>
#include <QPointF>
#include <cstddef>

namespace feedscope::ui {

/// Of the `curve`th curve of a study, from 0: Okabe and Ito's hues that stand out on the palette's plot.
QColor study_hue(std::size_t curve, const QPalette& palette);
/// Round, square, triangle, diamond: curves told apart without colour.
QPainterPath study_marker(std::size_t curve, const QPointF& at, double radius);

}  // namespace feedscope::ui
