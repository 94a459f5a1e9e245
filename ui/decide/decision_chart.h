#pragma once

#include <QWidget>
#include <optional>
#include <vector>

namespace feedscope::ui {

/// A run in a DecisionChart.
struct DecisionDot {
  std::size_t row = 0;  ///< of the run
  double time = 0;      ///< cycle time [s]
  double error = 0;     ///< contour error, the criterion of the choice [mm]
  QString name;         ///< short
  QColor colour;
  bool taken = false;  ///< whether it is the run to take
  bool current = false;
  bool actual = false;  ///< whether the error is the actual one, with drives
};

/// Name of a dot in a DecisionChart, or names of dots in one place.
struct DecisionLabel {
  QRectF place;
  QString text;
  std::vector<std::size_t> dots;  ///< their indices
  bool displaced = false;         ///< not next to its dots: a line leads there
};

/// Cycle time over contour error, with a dot for each run and a ring around the run to take. The bound on the
/// error is a vertical line that can be dragged.
class DecisionChart : public QWidget {
  Q_OBJECT

 public:
  explicit DecisionChart(QWidget* parent = nullptr);

  /// `bound`: on the error [mm].
  void set(std::vector<DecisionDot> dots, std::optional<double> bound);
  const std::vector<DecisionDot>& dots() const { return dots_; }
  /// Centre of a dot [pixels].
  QPointF place_of(const DecisionDot& dot) const;
  std::vector<DecisionLabel> labels() const;
  /// Abscissa of the bound's line; none without a bound.
  std::optional<double> bound_x() const;
  /// Text at the bound's line; empty without a bound.
  QRectF bound_label() const;

  /// Draws the chart at its size.
  void draw(QPainter& painter) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void run_clicked(std::size_t row);
  /// The user drags the bound to another value [mm].
  void bound_dragged(double bound);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  struct Scale {
    QRectF plot;
    double least_time = 0;
    double most_time = 1;
    double most_error = 1;  ///< [mm]
  };
  Scale scale() const;
  QString bound_text() const;
  QRectF mark_of(const DecisionDot& dot) const;
  std::vector<DecisionLabel> grouped_dots() const;
  void draw_axes(QPainter& painter, const Scale& scale) const;
  void draw_bound(QPainter& painter, const Scale& scale) const;
  void draw_dots(QPainter& painter) const;
  bool over_bound(const QPointF& place) const;

  std::vector<DecisionDot> dots_;
  std::optional<double> bound_;
  double most_error_ = 0;  ///< upper end of the axis [mm]
  bool dragging_ = false;
};

}  // namespace feedscope::ui
