#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QPainter>
#include <QValueAxis>

#include "ui/charts/chart_ground.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

QValueAxis* make_axis(QChart& chart, Qt::Alignment side) {
  auto* axis = new QValueAxis(&chart);
  axis->setTickType(QValueAxis::TicksDynamic);
  axis->setLabelsVisible(false);  // Qt Charts would shorten long numbers and write a hyphen for a minus
  chart.addAxis(axis, side);
  return axis;
}

void set_axis(QValueAxis& axis, const ChartAxis& shown, const ThemeColours& colours) {
  const double width = shown.range.upper - shown.range.lower;
  // The axis lays out its ticks after each of the two: in this order they stay few.
  if ((axis.max() - axis.min()) * axis.tickInterval() > width * shown.step) {
    axis.setRange(shown.range.lower, shown.range.upper);
  }
  axis.setTickInterval(shown.step);
  axis.setRange(shown.range.lower, shown.range.upper);
  axis.setGridLineColor(colours.grid);
  axis.setLinePenColor(colours.frame);
}

}  // namespace

struct ChartGround::Parts {
  QGraphicsScene scene;
  QChart* chart = new QChart;  ///< of the scene, as its axes
  QValueAxis* abscissa = make_axis(*chart, Qt::AlignBottom);
  QValueAxis* ordinate = make_axis(*chart, Qt::AlignLeft);
};

ChartGround::ChartGround() : parts_(std::make_unique<Parts>()) {
  QChart& chart = *parts_->chart;
  parts_->scene.addItem(&chart);
  chart.legend()->hide();
  chart.setBackgroundRoundness(0);
  chart.setMargins({});
  chart.setAnimationOptions(QChart::NoAnimation);
  chart.layout()->setContentsMargins(0, 0, 0, 0);
}

ChartGround::~ChartGround() = default;

void ChartGround::draw(QPainter& painter, const QRect& whole, const QRectF& plot, const ChartAxis& abscissa,
                       const ChartAxis& ordinate, const ThemeColours& colours) const {
  QChart& chart = *parts_->chart;
  chart.setBackgroundBrush(colours.plot);
  chart.resize(whole.size());
  chart.setPlotArea(plot);
  set_axis(*parts_->abscissa, abscissa, colours);
  set_axis(*parts_->ordinate, ordinate, colours);
  chart.layout()->activate();
  parts_->scene.render(&painter, whole, whole);
}

}  // namespace feedscope::ui
