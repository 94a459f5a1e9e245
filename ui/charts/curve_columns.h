#pragma once

#include <QColor>
#include <QRectF>
#include <span>

class QPainter;

namespace feedscope::ui {

/// Range that a curve covers in one pixel column [px, downwards]; empty where top > bottom.
struct ColumnSpan {
  double top = 1;
  double bottom = 0;

  bool empty() const { return !(top <= bottom); }
  double height() const { return bottom - top; }
};

struct CurvePen {
  QColor color;
  double width = 1;     ///< [px]
  bool dashed = false;  ///< 6 columns drawn, 4 omitted
  bool hollow = false;  ///< only the extremes where the curve oscillates
};

/// Whether the columns are bars that hide the curve: it oscillates within each of them, so that neighbours
/// overlap much. A curve that rises and falls over many columns only touches its neighbours. Uses the range
/// without the 5 % at either end, so that single peaks do not count.
bool hidden_in_bars(std::span<const ColumnSpan> columns);

/// Mean height of the non-empty columns [px].
double mean_height(std::span<const ColumnSpan> columns);

/// Draws a curve over equally wide columns of `plot`. Columns that the curve oscillates within are filled one
/// by one; the others form one smooth band. The time is linear in the number of columns for any curve.
void draw_columns(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> columns,
                  const CurvePen& pen);

/// Fills the gaps of a hollow pen, so that overlapping oscillating curves remain visible: first the insides
/// of all in a pale colour, then each curve.
void fill_hollows(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> columns,
                  const CurvePen& pen);

}  // namespace feedscope::ui
