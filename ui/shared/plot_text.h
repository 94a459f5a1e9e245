#pragma once

#include <QColor>
#include <QRectF>
#include <QString>

#include "core/base/ticks.h"

class QPainter;

namespace feedscope::ui {

/// A value of `ticks` in seconds: "0:20", "1:40" on a scale that reaches a minute, unless the step is too
/// fine for that; else as tick_text().
QString time_tick_text(const Ticks& ticks, std::size_t i);
/// The title of a scale with these ticks: with " [s]" where they are seconds.
QString time_scale_title(const QString& title, const Ticks& ticks);

/// Black or white, whichever contrasts better with the colour.
QColor text_on(const QColor& ground);

/// A title in bold at the upper left of `area` and details after it, both shortened to its width. Uses the
/// painter's pen, and its font for the details; the title is a quarter larger.
void paint_title(QPainter& painter, const QRectF& area, const QString& title, const QString& details);

}  // namespace feedscope::ui
