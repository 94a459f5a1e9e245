#pragma once

#include <QFont>
#include <QRectF>
#include <QSize>
#include <QString>
#include <vector>

#include "core/base/ticks.h"
#include "ui/runs/comparison_bars.h"

namespace feedscope::ui {

/// A column of texts next to the bars: its heading in two lines, the second the unit or the rest of the name.
struct TextColumn {
  QString heading;
  QString below;
  std::vector<QString> texts;  ///< one for each run
  Qt::AlignmentFlag side = Qt::AlignRight;
  double left = 0;
  double right = 0;
};

/// Places of all parts of a comparison [px]: title, legend, column headings, then a row for each run with
/// its name, its bar and its figures, and the time axis below.
struct ComparisonLayout {
  QRectF title;
  std::vector<QString> legend_texts;  ///< kinds, the rest, refused lines, the programmed time
  std::vector<QRectF> legend;         ///< with room for the swatch before the text
  QRectF headings;
  std::vector<TextColumn> names;    ///< left of the plot: model, tolerance
  std::vector<TextColumn> figures;  ///< right of the plot
  std::vector<QRectF> machines;     ///< the line above the runs of each machine
  std::vector<QRectF> rows;         ///< one for each run, over the whole width
  QRectF plot;                      ///< around the rows; 0 s at its left
  QRectF axis;                      ///< below the plot
  double bar_height = 0;
  Ticks ticks;  ///< [s]
  double pixels_per_second = 0;

  double x_of(double time) const { return plot.left() + time * pixels_per_second; }
};

/// Room for the swatch before a legend's text [px].
inline constexpr double legend_swatch = 20;

/// `size` at least min_comparison_size(). Rows grow with the height up to a maximum.
ComparisonLayout lay_out(const ComparisonBars& bars, const QSize& size, const QFont& font);

/// The height for easily readable rows in a picture of this width, and the smallest height in which they fit.
int natural_comparison_height(const ComparisonBars& bars, int width, const QFont& font);
int min_comparison_height(const ComparisonBars& bars, int width, const QFont& font);

/// Smallest width of a comparison [px].
inline constexpr int min_comparison_width = 640;
/// At least min_comparison_height for the runs of `bars`, whatever their limiting causes.
int enough_comparison_height(const ComparisonBars& bars, int width);

}  // namespace feedscope::ui
