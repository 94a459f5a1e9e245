#pragma once

#include <QPixmap>
#include <QPolygonF>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ui/charts/chart_ground.h"
#include "ui/charts/chart_spec.h"
#include "ui/charts/limit_line.h"
#include "ui/charts/value_fit.h"
#include "ui/shared/view_range.h"

namespace feedscope::ui {

/// A curve of another run.
struct OverlayCurve {
  std::vector<Extent> columns;  ///< internal units, over the shown range
  QColor color;
  bool dashed = false;
};

class ChartInput;

/// One chart of a run: curves as bands of pixel columns, axis limits and cursors.
///
/// The wheel zooms at the pointer (Ctrl: the values). Shift and wheel, or dragging, pans. Ctrl and dragging,
/// or dragging with the right button, zooms to the box. A double click shows all; a click requests the
/// cursor, a Shift click the second one. All charts share the shown range.
class KinematicChart : public QWidget {
  Q_OBJECT

 public:
  /// `range` outlives this.
  KinematicChart(ChartSpec spec, ViewRange& range, QWidget* parent = nullptr);

  const ChartSpec& spec() const { return spec_; }
  /// Pixel columns of the plot on the screen.
  int column_count() const;
  /// For pictures: columns per screen pixel.
  void set_resolution(double columns) { resolution_ = columns; }
  void set_limits(std::vector<LimitLine> limits);
  /// Cutting feeds in the shown range, internal units: a feed chart omits much faster rapids, and notes it.
  /// None without cutting.
  void set_cutting_feed(const std::optional<CuttingFeed>& feed);
  /// The same for acceleration and jerk: what each run reaches without its rapids. Empty without cutting.
  void set_cutting(std::vector<MotionBand> runs) { cutting_ = std::move(runs); }
  /// Mean of the first curve in each column, internal units. Drawn where the columns are high and show only
  /// the extremes. Empty: none. Columns as of show_bands().
  void set_means(std::vector<float> means);
  /// Usual ranges of the curves over stretches of so many columns each. Drawn over pale columns where a curve
  /// oscillates within the columns and covers much of the plot, or has rare peaks. Empty: unknown.
  void set_usual(const std::vector<MotionBand>& ranges, std::size_t columns);
  bool shows_usual() const;
  /// Whether the acceleration has jumps, which a chart of jerk does not show.
  void set_jumps(bool jumps) { jumps_ = jumps; }
  /// The drawn mean lines.
  std::vector<QPolygonF> mean_lines() const;
  void show_curve(std::size_t curve, bool shown);
  bool curve_shown(std::size_t curve) const { return shown_[curve]; }
  /// Draws equally wide columns from the lower to the upper end of the range, over other runs.
  void show_bands(std::span<const Band> bands, std::vector<OverlayCurve> overlays = {});
  /// Positions of the cursors along the abscissa.
  void set_cursors(std::optional<double> first, std::optional<double> second);
  const std::optional<double>& cursor() const { return cursor_; }
  const std::optional<double>& second_cursor() const { return second_cursor_; }
  /// Labels the abscissa with numbers and this title; without a title, no labels.
  void label_abscissa(const QString& title);

  /// The shown ordinate, in the chart's unit.
  const Interval& values() const { return values_; }
  /// The ordinate chosen by the user; none: it follows the curves.
  const std::optional<Interval>& chosen_values() const { return chosen_values_; }
  /// Ignores an interval too narrow or too wide for its tick labels.
  void choose_values(const std::optional<Interval>& values);

  /// Notes on values that the plot omits or adds, and on its limits, for display next to the curves.
  QStringList notes() const;
  std::vector<LimitLine> limits_in_sight() const;

  /// Where the curves are [px].
  const QRectF& plot() const { return plot_; }
  /// Position in the widget [px].
  double pixel_of(double position) const;
  double position_at(double pixel) const;
  double height_of(double value) const;
  double value_at(double height) const;

  /// Draws everything except the box of the mouse.
  void draw(QPainter& painter) const;

 signals:
  void position_clicked(double position);
  void second_position_clicked(double position);
  void menu_requested(const QPoint& global);
  void plot_resized();
  /// The user chose or reset the ordinate.
  void values_chosen();
  /// Requests the whole run and all values.
  void fit_requested();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void lay_out();
  void redraw();
  void follow_type_size();
  void fit();
  /// Values that rapids must not dwarf; none without cutting.
  std::optional<CuttingFeed> cutting_values() const;
  CurveReach reach_of(const std::vector<Extent>& columns, bool may_be_cut) const;
  /// Whether a shown curve of the limit's axis is anything but zero.
  bool moves(const LimitLine& limit) const;
  void draw_picture(QPainter& painter) const;
  void draw_ordinate(QPainter& painter) const;
  /// Between ticks; of the range in sight, which changes before the curves follow.
  double abscissa_step() const;
  void draw_abscissa(QPainter& painter) const;
  void draw_curves(QPainter& painter) const;
  void draw_extents(QPainter& painter, const std::vector<Extent>& extents, const QColor& color, double width,
                    bool dashed) const;
  void draw_cursors(QPainter& painter) const;

  ChartSpec spec_;
  ViewRange& range_;
  ChartGround ground_;
  QRectF plot_;
  QString abscissa_title_;
  double ordinate_step_ = 1;                  ///< between ticks
  std::vector<std::vector<Extent>> columns_;  ///< one for each curve, internal units
  std::vector<std::vector<Extent>> usual_;    ///< one for each curve, internal units
  std::size_t columns_a_stretch_ = 1;         ///< of usual_
  std::vector<bool> shown_;                   ///< one for each curve
  std::vector<float> means_;                  ///< of the first curve, internal units
  std::vector<OverlayCurve> overlays_;
  std::vector<LimitLine> limits_;
  std::vector<LimitLine> shown_limits_;  ///< of axes that move here
  std::optional<CuttingFeed> cutting_feed_;
  std::vector<MotionBand> cutting_;
  Interval values_{0, 1};
  std::optional<double> fastest_rapid_;      ///< of the rapids out of sight, in the chart's unit
  std::optional<double> programmed_beyond_;  ///< largest programmed feed, if it is out of sight
  std::optional<Interval> chosen_values_;
  std::optional<double> cursor_;
  std::optional<double> second_cursor_;
  QPixmap picture_;  ///< the chart without cursors; null when it must be drawn again
  bool jumps_ = false;
  double resolution_ = 1;
  ChartInput* input_;
};

}  // namespace feedscope::ui
