#include "ui/contour/contour_chart.h"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <cmath>
#include <utility>

#include "ui/language/shown_numbers.h"

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
  const QLocale locale;
  const auto edge = [&](std::size_t i) {
    return in_shown_unit(shown.histogram(0).edges[i], Dimension::error);
  };
  const auto text = [&](double value) { return locale.toString(std::abs(value), 'g', 3); };
  const auto amount = [&](double value) { return text(value) + ' ' + unit_of(Dimension::error); };
  const double from = edge(*bin);
  const double to = edge(*bin + 1);
  QString tip;
  if (!curves_.sides) {
    tip = tr("%1 to %2 from the programmed path").arg(text(from), amount(to));
  } else if (from < 0 && to > 0) {
    tip = tr("At most %1 left or right of the programmed path").arg(amount(to));
  } else {
    tip =
        (from >= 0 ? tr("%1 to %2 left of the programmed path") : tr("%1 to %2 right of the programmed path"))
            .arg(text(from >= 0 ? from : to), amount(from >= 0 ? to : from));
  }
  for (std::size_t i = 0; i < curves_.runs.size(); ++i) {
    tip += QStringLiteral("\n") +
           tr("%1: %2 of the path")
               .arg(curves_.runs[i].name,
                    significant_text(shown.histogram(i).length[*bin], Dimension::length, 4));
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
