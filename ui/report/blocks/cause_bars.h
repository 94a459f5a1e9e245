#pragma once

#include <QSizeF>

#include "ui/runs/comparison_bars.h"

class QPainter;

namespace feedscope::ui {

/// Runs as bars as long as their cycle times, cut by what limits the feed, with a letter before and the cycle
/// time after each, the time in parts that have room for it, and a legend of the parts below.
class CauseBars {
 public:
  /// `width`: total [1/96 inch].
  CauseBars(ComparisonBars bars, double width);

  /// Width and required height.
  QSizeF size() const { return size_; }
  void paint(QPainter& painter) const;
  /// Whether times of parts are "4:13" and not seconds, as one is longer than a minute.
  bool on_the_clock() const;

 private:
  void paint_bar(QPainter& painter, const ComparisonBar& bar, const QRectF& room) const;
  void paint_legend(QPainter& painter) const;

  ComparisonBars bars_;
  QSizeF size_;
  double legend_top_ = 0;
};

}  // namespace feedscope::ui
