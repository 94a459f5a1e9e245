#include "ui/charts/contour_chart.h"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <cmath>
#include <utility>

namespace feedscope::ui {

ContourChart::ContourChart(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Histogram of the contour error"));
}

void ContourChart::set_curves(ContourCurves curves) {
  curves_ = std::move(curves);
  update();
}

QSize ContourChart::sizeHint() const {
  return {480, 260};
}

QSize ContourChart::minimumSizeHint() const {
  return {220, 150};
}

ContourPlot ContourChart::plot() const {
  return {curves_, rect(), font(), theme_colours(palette())};
}

void ContourChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme_colours(palette()).plot);
  if (!curves_.runs.empty()) {
    plot().draw(painter);
  }
}

QString ContourChart::tip_at(const QPointF& place) const {
  if (curves_.runs.empty()) {
    return {};
  }
  const ContourPlot shown = plot();
  const std::optional<std::size_t> bin = shown.bin_at(place);
  if (!bin) {
    return {};
  }
  constexpr double micrometres = 1000;
  const QLocale locale;
  const auto edge = [&](std::size_t i) { return shown.histogram(0).edges[i] * micrometres; };
  const auto text = [&](double value) { return locale.toString(std::abs(value), 'g', 3); };
  const double from = edge(*bin);
  const double to = edge(*bin + 1);
  QString tip;
  if (!curves_.sides) {
    tip = tr("%1 to %2 µm from the programmed path").arg(text(from), text(to));
  } else if (from < 0 && to > 0) {
    tip = tr("At most %1 µm left or right of the programmed path").arg(text(to));
  } else {
    tip = (from >= 0 ? tr("%1 to %2 µm left of the programmed path")
                     : tr("%1 to %2 µm right of the programmed path"))
              .arg(text(from >= 0 ? from : to), text(from >= 0 ? to : from));
  }
  for (std::size_t i = 0; i < curves_.runs.size(); ++i) {
    tip += QStringLiteral("\n") +
           tr("%1: %2 mm of the path")
               .arg(curves_.runs[i].name, locale.toString(shown.histogram(i).length[*bin], 'g', 4));
  }
  return tip;
}

bool ContourChart::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString tip = tip_at(help->pos());
    tip.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), tip, this);
    return true;
  }
  return QWidget::event(event);
}

}  // namespace feedscope::ui
