#include "ui/identification/residual_chart.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

namespace feedscope::ui {

ResidualChart::ResidualChart(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("What the models leave over of the recordings"));
  setToolTip(tr(
      "How far the simulation is behind the recording as it goes on, or what it is longer in each section. "
      "A level curve: feed and time agree there; a step: a place that takes longer or shorter"));
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  hide();
}

void ResidualChart::set_outcome(const std::shared_ptr<const IdentificationOutcome>& outcome,
                                std::size_t chosen) {
  curves_ = outcome == nullptr ? std::vector<ResidualCurves>() : residual_curves(*outcome, chosen);
  setVisible(!curves_.empty());
  updateGeometry();
  update();
}

QSize ResidualChart::sizeHint() const {
  constexpr int width_in_lines = 12;
  constexpr int height_in_lines = 11;
  const int line = QFontMetrics(font()).height();
  std::size_t legend = 0;  // lines
  for (const ResidualCurves& curves : curves_) {
    legend += curves.models.size() > 1 ? curves.models.size() : 0;
  }
  return {width_in_lines * line, line * static_cast<int>(height_in_lines * curves_.size() + legend)};
}

void ResidualChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColours& colours = theme_colours(palette());
  painter.fillRect(rect(), colours.plot);
  const double height = this->height() / static_cast<double>(std::max<std::size_t>(1, curves_.size()));
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const QRectF area(0, static_cast<double>(i) * height, width(), height);
    ResidualPlot(curves_[i], area, font(), colours).draw(painter);
  }
}

}  // namespace feedscope::ui
