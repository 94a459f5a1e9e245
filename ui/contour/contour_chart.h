#pragma once

#include <QWidget>

#include "ui/contour/contour_plot.h"

namespace feedscope::ui {

/// A ContourPlot on screen; a tooltip describes the place under the pointer.
class ContourChart : public QWidget {
  Q_OBJECT

 public:
  explicit ContourChart(QWidget* parent = nullptr);

  void set_curves(ContourCurves curves);
  const ContourCurves& curves() const { return curves_; }
  /// Tooltip of a place in the chart; empty outside of bars.
  QString tip_at(const QPointF& place) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  ContourPlot plot() const;

  ContourCurves curves_;
};

}  // namespace feedscope::ui
