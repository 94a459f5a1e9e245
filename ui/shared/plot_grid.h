#pragma once

#include <QColor>
#include <QRectF>
#include <QString>
#include <span>
#include <vector>

#include "core/base/ticks.h"

class QPainter;

namespace feedscope::ui {

/// Colours and distances of a PlotGrid.
struct GridLook {
  QColor grid;
  QColor strong;  ///< of the line at zero
  QColor text;
  double beside = 8;  ///< from the plot to the labels left of it [pixels]
  double below = 6;   ///< from the plot to the labels under it [pixels]
  double tick = 4;    ///< extension of horizontal and vertical lines beyond the plot [pixels]
};

enum class GridLine { usual, strong };

/// Grid lines of a painted chart with their labels. Lines are on whole pixels; a label that would touch the
/// previous one along the same axis is omitted.
class PlotGrid {
 public:
  /// The painter has the font of the labels and outlives this.
  PlotGrid(QPainter& painter, const QRectF& plot, GridLook look);

  /// A horizontal line at a height of the plot, with its label, if any, left of the plot.
  void level(double y, const QString& label, GridLine line = GridLine::usual);
  /// A vertical line, with its label, if any, under the plot.
  void upright(double x, const QString& label, GridLine line = GridLine::usual);
  /// Continues vertical lines through this plot, which is above or below and shares the axis, without a tick.
  void share(const QRectF& plot) { shared_ = plot; }

 private:
  void draw_label(const QRectF& place, Qt::Alignment side, const QString& label, QRectF& last);

  QPainter& painter_;
  QRectF plot_;
  QRectF shared_;
  GridLook look_;
  QRectF last_beside_;  ///< the last label drawn
  QRectF last_below_;
};

/// A value of `ticks` in the locale, with decimals by the step.
QString tick_text(const Ticks& ticks, std::size_t i);

/// Places entries of these widths in rows from the left to the right of `area`, in as many rows as needed.
/// `line`: height of an entry, `row`: from one row to the next, `gap`: between entries [pixels].
std::vector<QRectF> entries_in_rows(std::span<const double> widths, const QRectF& area, double line,
                                    double row, double gap);

}  // namespace feedscope::ui
