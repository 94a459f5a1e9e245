#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "core/analysis/contour/contour_histogram.h"
#include "ui/shared/plot_grid.h"
#include "ui/theme/theme.h"

class QPainter;

namespace feedscope::ui {

/// A run of a ContourPlot.
struct ContourCurve {
  QString name;
  QColor colour;
  double largest = 0;  ///< contour error [mm]
  ContourSpread spread;

  /// The largest error left or right of the path in XY, without the part along Z [mm].
  double largest_beside() const;
};

/// Contents of a ContourPlot. The first run is filled, the others are outlines.
struct ContourCurves {
  std::vector<ContourCurve> runs;
  /// Left and right of the programmed path in XY, left to the left; else the magnitude only.
  bool sides = false;
  std::optional<std::array<double, 2>> tolerance;  ///< smallest and largest of the first run [mm]

  double largest() const;  ///< of all runs [mm]
  /// The largest error in the histograms: sides omit the part along Z [mm].
  double extent() const;
  /// With equal edges for all runs.
  ContourHistogram histogram(std::size_t run) const;
};

/// Path length by contour error as bars. The length has a logarithmic axis: most of a path follows the
/// program closely, and the few millimetres that do not are what matters.
class ContourPlot {
 public:
  /// Layout in `area`; `curves` outlives this.
  ContourPlot(const ContourCurves& curves, const QRectF& area, const QFont& font,
              const ThemeColours& colours);

  void draw(QPainter& painter) const;
  /// The bin under a place of the plot.
  std::optional<std::size_t> bin_at(const QPointF& place) const;
  const ContourHistogram& histogram(std::size_t run) const { return histograms_[run]; }
  const QRectF& plot() const { return plot_; }

 private:
  void lay_out_legend(const QRectF& area);
  void choose_scales();
  double x(double error) const;   ///< of a signed error [mm]
  double y(double length) const;  ///< [mm]
  GridLook grid_look() const;
  void draw_legend(QPainter& painter) const;
  void draw_lengths(QPainter& painter) const;
  void draw_errors(QPainter& painter) const;
  void draw_sides(QPainter& painter) const;
  void draw_bars(QPainter& painter) const;
  void draw_outline(QPainter& painter, std::size_t run) const;
  void draw_tolerance(QPainter& painter) const;
  QString entry_text(std::size_t run, double room) const;
  /// The bar of a bin: as wide as the bin, but not beyond the largest error of the run.
  QRectF bar(std::size_t run, std::size_t bin) const;
  /// The line `rows` lines beneath the plot's lower edge.
  QRectF below(double rows) const;

  const ContourCurves& curves_;
  QFont font_;
  const ThemeColours& colours_;
  double line_;                               ///< height of a line of text
  std::vector<ContourHistogram> histograms_;  ///< of all runs, with the same edges
  std::vector<QRectF> legend_;
  QRectF plot_;
  double max_error_ = 1;     ///< at the end of the axis [mm]
  double min_length_ = 0.1;  ///< a power of ten [mm]
  double max_length_ = 1;
};

}  // namespace feedscope::ui
