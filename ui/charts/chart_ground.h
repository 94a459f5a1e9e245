#pragma once

#include <memory>

#include "ui/charts/value_fit.h"

class QPainter;
class QRect;
class QRectF;

namespace feedscope::ui {

struct ThemeColours;

/// An axis of a chart, with lines of the grid at the multiples of `step`.
struct ChartAxis {
  Interval range;
  double step = 1;
};

/// Ground, grid and the lines left of the plot and under it, as Qt Charts draws them (with_qt_charts.cpp) or
/// a build without it (without_qt_charts.cpp).
class ChartGround {
 public:
  ChartGround();
  ~ChartGround();
  ChartGround(const ChartGround&) = delete;
  ChartGround& operator=(const ChartGround&) = delete;

  /// `whole`: the chart with its margins, `plot`: where the curves are [px].
  void draw(QPainter& painter, const QRect& whole, const QRectF& plot, const ChartAxis& abscissa,
            const ChartAxis& ordinate, const ThemeColours& colours) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace feedscope::ui
