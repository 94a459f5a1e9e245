#pragma once

#include <QSizeF>

#include "ui/runs/comparison_bars.h"

class QPainter;

namespace feedscope::ui {

/// Runs as bars as long as their cycle times, divided by limiting cause, with a letter before and the cycle
/// time after each, seconds in parts with room for them, and a legend below.
class CauseBars {
 public:
  /// `width`: total [1/96 inch].
  CauseBars(ComparisonBars bars, double width);

  /// Width and required height.
  QSizeF size() const { return size_; }
  void paint(QPainter& painter) const;

 private:
  void paint_bar(QPainter& painter, const ComparisonBar& bar, const QRectF& room) const;
  void paint_legend(QPainter& painter) const;

  ComparisonBars bars_;
  QSizeF size_;
  double legend_top_ = 0;
};

}  // namespace feedscope::ui
