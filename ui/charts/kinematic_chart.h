#pragma once

#include <QChartView>
#include <QPixmap>
#include <QString>
#include <optional>
#include <span>
#include <vector>

#include "ui/charts/envelope.h"
#include "ui/charts/view_range.h"

class QLineSeries;
class QValueAxis;

namespace feedscope::ui {

struct CurveSpec {
  Channel channel;
  QString name;
  QColor color;
  double width = 1;         ///< [px]
  bool may_be_cut = false;  ///< the chart need not grow far beyond the other curves to show it in full
};

/// A permitted largest magnitude, drawn dashed on the sides of zero that the chart shows.
struct LimitLine {
  double value = 0;  ///< in the chart's unit
  QString label;
  QColor color;
};

struct ChartSpec {
  QString title;
  QString unit;
  std::vector<CurveSpec> curves;        ///< as the header lists them
  double (*convert)(double) = nullptr;  ///< from the core's unit to `unit`
  int decimals = 0;                     ///< of values shown as numbers
};

/// One chart of a run: curves as bands of pixel columns, axis limits and the cursor.
///
/// The wheel zooms at the pointer, dragging pans, a double click shows all; a click asks for the cursor. The
/// shown range is shared with the other charts.
class KinematicChart : public QChartView {
  Q_OBJECT

 public:
  /// `range` outlives this. `labelled`: numbers and title along the abscissa.
  KinematicChart(ChartSpec spec, ViewRange& range, bool labelled, QWidget* parent = nullptr);

  const ChartSpec& spec() const { return spec_; }
  /// Pixel columns of the plot.
  int column_count() const;
  void set_limits(std::vector<LimitLine> limits);
  /// Draws equally wide columns from the lower to the upper end of the range.
  void show_bands(std::span<const Band> bands);
  /// Position of the cursor along the abscissa.
  void set_cursor(std::optional<double> position);
  const std::optional<double>& cursor() const { return cursor_; }
  void set_abscissa_title(const QString& title);

  /// Place of a position in the viewport [px].
  double pixel_of(double position) const;

 signals:
  void position_clicked(double position);
  void plot_resized();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  double position_at(double pixel) const;
  /// Gives the largest curve the lowest layer, so that none hides another.
  void stack_curves(const std::vector<Extent>& extents, const std::vector<QList<QPointF>>& points);
  void fit_values(const std::vector<Extent>& extents);
  void draw_limits(QPainter& painter) const;
  void draw_cursor(QPainter& painter) const;

  ChartSpec spec_;
  ViewRange& range_;
  bool labelled_;
  QValueAxis* abscissa_;
  QValueAxis* ordinate_;
  std::vector<QLineSeries*> layers_;  ///< from the lowest up
  std::vector<LimitLine> limits_;
  std::optional<double> cursor_;
  QPixmap picture_;  ///< the chart without the cursor; null when it must be drawn again
  QPointF pressed_at_;
  QPointF dragged_from_;
  bool dragging_ = false;
};

}  // namespace feedscope::ui
