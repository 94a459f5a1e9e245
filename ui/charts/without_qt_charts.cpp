#include <QPainter>

#include "core/base/ticks.h"
#include "ui/charts/chart_ground.h"
#include "ui/shared/plot_grid.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

struct ChartGround::Parts {};

ChartGround::ChartGround() = default;
ChartGround::~ChartGround() = default;

void ChartGround::draw(QPainter& painter, const QRect&, const QRectF& plot, const ChartAxis& abscissa,
                       const ChartAxis& ordinate, const ThemeColours& colours) const {
  PlotGrid grid(painter, plot,
                {.grid = colours.grid, .strong = colours.frame, .text = colours.text, .tick = 0});
  const auto share = [](const ChartAxis& axis, double value) {
    return (value - axis.range.lower) / axis.range.width();
  };
  for (const double tick : multiples(abscissa.step, abscissa.range.lower, abscissa.range.upper)) {
    grid.upright(plot.left() + share(abscissa, tick) * plot.width(), {});
  }
  for (const double tick : multiples(ordinate.step, ordinate.range.lower, ordinate.range.upper)) {
    grid.level(plot.bottom() - share(ordinate, tick) * plot.height(), {});
  }
  grid.upright(plot.left(), {}, GridLine::strong);
  grid.level(plot.bottom(), {}, GridLine::strong);
}

}  // namespace feedscope::ui
