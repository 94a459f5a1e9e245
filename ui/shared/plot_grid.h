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
  double tick = 4;    ///< that lines across reach beyond the plot [pixels]
};

enum class GridLine { usual, strong };

/// Grid lines of a painted chart with their labels. Lines lie on whole pixels; a label that would touch the
/// one drawn before it along the same axis is omitted.
class PlotGrid {
 public:
  /// The painter has the font of the labels and outlives this.
  PlotGrid(QPainter& painter, const QRectF& plot, GridLook look);

  /// A level line at a height of the plot, its label left of the plot.
  void level(double y, const QString& label, GridLine line = GridLine::usual);
  /// An upright line, its label under the plot.
  void upright(double x, const QString& label, GridLine line = GridLine::usual);
  /// The same through this plot too, which lies above or below and shares the axis, without a tick.
  void share(const QRectF& plot) { shared_ = plot; }

 private:
  void draw_label(const QRectF& place, Qt::Alignment side, const QString& label, QRectF& last);

  QPainter& painter_;
  QRectF plot_;
  QRectF shared_;
  GridLook look_;
  QRectF last_beside_;  ///< label that was drawn last
  QRectF last_below_;
};

/// A value of `ticks` by the locale, with as many decimals as the step needs.
QString tick_text(const Ticks& ticks, std::size_t i);

/// Places entries of these widths in rows from the left to the right of `area`, as many rows as they need.
/// `line`: height of an entry, `row`: from one row to the next, `gap`: between entries [pixels].
std::vector<QRectF> entries_in_rows(std::span<const double> widths, const QRectF& area, double line,
                                    double row, double gap);

}  // namespace feedscope::ui
