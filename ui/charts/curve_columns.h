#pragma once

#include <QColor>
#include <QRectF>
#include <span>

class QPainter;

namespace feedscope::ui {

/// What a curve covers in one pixel column [px, downwards]; empty where top > bottom.
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
  bool hollow = false;  ///< where the curve swings within the columns only its largest and least values
};

/// Whether the columns are bars that hide the curve: it swings within each, so that neighbours cover much of
/// each other; a curve that rises and falls over many columns touches its neighbours only. Measured by what
/// the curve reaches but for the 5 % at either end, so that single peaks do not count.
bool hidden_in_bars(std::span<const ColumnSpan> columns);

/// Mean height of those that are not empty [px].
double mean_height(std::span<const ColumnSpan> columns);

/// Draws a curve over equally wide columns of `plot`. Where it swings to and fro within the columns they are
/// filled one by one, elsewhere they make one smooth band: linear in the columns, whatever the curve does.
void draw_columns(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> columns,
                  const CurvePen& pen);

/// Fills what a hollow pen leaves out, so that curves that swing one over the other can all be seen: first
/// what is inside of each in a pale colour, then each curve.
void fill_hollows(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> columns,
                  const CurvePen& pen);

}  // namespace feedscope::ui
