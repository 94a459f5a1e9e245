#include "ui/shared/plot_text.h"

#include <QFont>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/language/texts.h"
#include "ui/shared/plot_grid.h"

namespace feedscope::ui {

namespace {

constexpr double minute = 60;  // [s]

bool on_the_clock(const Ticks& ticks) {
  constexpr double clock_step = 0.1;  // clock_text() has one decimal
  return !ticks.values.empty() && ticks.values.back() >= minute && ticks.step >= clock_step;
}

}  // namespace

QString time_tick_text(const Ticks& ticks, std::size_t i) {
  const double value = ticks.values[i];
  if (!on_the_clock(ticks) || value == 0) {
    return tick_text(ticks, i);
  }
  const QString text =
      value < minute ? QStringLiteral("0:%1").arg(QLocale().toString(value, 'f', 1), 4, QLatin1Char('0'))
                     : clock_text(value);
  return ticks.step == std::floor(ticks.step) ? text.section(QLocale().decimalPoint(), 0, 0) : text;
}

QString time_scale_title(const QString& title, const Ticks& ticks) {
  return on_the_clock(ticks) ? title : QStringLiteral("%1 [s]").arg(title);
}

QColor text_on(const QColor& ground) {
  const double luminance = 0.2126 * std::pow(ground.redF(), 2.2) + 0.7152 * std::pow(ground.greenF(), 2.2) +
                           0.0722 * std::pow(ground.blueF(), 2.2);
  constexpr double light = 0.27;
  return luminance > light ? QColor(0x33, 0x38, 0x3e) : QColor(Qt::white);
}

void paint_title(QPainter& painter, const QRectF& area, const QString& title, const QString& details) {
  constexpr double gap = 10;
  const QFont font = painter.font();
  QFont bold = font;
  bold.setBold(true);
  bold.setPixelSize(font.pixelSize() * 5 / 4);
  const QFontMetricsF bold_metrics(bold);
  const QFontMetricsF metrics(font);
  const double details_width = std::min(metrics.horizontalAdvance(details), area.width() / 2);
  const QString shown = bold_metrics.elidedText(title, Qt::ElideMiddle, area.width() - details_width - gap);
  painter.setFont(bold);
  painter.drawText(area, Qt::AlignLeft | Qt::AlignTop, shown);
  painter.setFont(font);
  const double left = area.left() + bold_metrics.horizontalAdvance(shown) + gap;
  const double top = area.top() + bold_metrics.ascent() - metrics.ascent();
  painter.drawText(QRectF(left, top, area.right() - left, metrics.height()), Qt::AlignLeft | Qt::AlignTop,
                   metrics.elidedText(details, Qt::ElideRight, area.right() - left));
}

}  // namespace feedscope::ui
