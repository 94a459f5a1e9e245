#pragma once

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <vector>

#include "ui/identification/identification_outcome.h"
#include "ui/shared/plot_grid.h"
#include "ui/theme/theme.h"

class QPainter;

namespace feedscope::ui {

/// Residuals of a model for one recording.
struct ResidualCurve {
  QString name;  ///< of the model
  QColor colour;
  /// Recorded time [s] and delay of the simulation [s]; for a table the number of each section and the excess
  /// of its simulated time [s].
  std::vector<QPointF> points;
};

/// Residuals of all models for one recording.
struct ResidualCurves {
  QString recording;  ///< name of its file
  bool of_sections = false;
  std::vector<ResidualCurve> models;  ///< the chosen one first
};

/// For each recording. `chosen`: row of the selected model.
std::vector<ResidualCurves> residual_curves(const IdentificationOutcome& outcome, std::size_t chosen);

/// The residuals of one recording as curves over its time, or as bars by section. The scale is that of the
/// chosen model; much larger residuals of others leave the plot.
class ResidualPlot {
 public:
  /// Layout in `area`; `curves` outlives this.
  ResidualPlot(const ResidualCurves& curves, const QRectF& area, const QFont& font,
               const ThemeColours& colours);

  void draw(QPainter& painter) const;
  const QRectF& plot() const { return plot_; }
  double lowest() const { return lowest_; }    ///< residual at the bottom [s]
  double highest() const { return highest_; }  ///< at the top [s]

 private:
  void lay_out_legend(const QRectF& area);
  void choose_scales();
  QPointF place_of(const QPointF& point) const;
  bool in_milliseconds() const;
  void draw_titles(QPainter& painter) const;
  void draw_legend(QPainter& painter) const;
  void draw_scales(QPainter& painter) const;
  void draw_curve(QPainter& painter, std::size_t model) const;
  void draw_bars(QPainter& painter, std::size_t model) const;

  const ResidualCurves& curves_;
  QFont font_;
  const ThemeColours& colours_;
  QRectF area_;
  double line_;  ///< height of a line of text
  std::vector<QRectF> legend_;
  QRectF plot_;
  double first_ = 0;
  double last_ = 1;
  double lowest_ = 0;
  double highest_ = 0;
};

}  // namespace feedscope::ui
