#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/study/study_curves.h"

namespace feedscope::ui {

/// Cycle time and, below it over the same axis, contour error against a setting. The bound is a dashed line;
/// the recommended run of each curve is ringed and labelled. Curves differ in colour and in marker;
/// recordings of the program are dotted horizontal lines.
class StudyChart : public QWidget {
  Q_OBJECT

 public:
  explicit StudyChart(QWidget* parent = nullptr);
  void set_study(const QString& title, const QString& details, StudyCurves study);
  const StudyCurves& study() const { return study_; }
  /// Traces of the whole program for comparison with the runs of the study.
  void set_recorded(std::vector<RecordedTime> recorded);
  /// The run with a marker at most a few pixels away: index of its curve and of its point.
  struct Hit {
    std::size_t curve = 0;
    std::size_t point = 0;
  };
  std::optional<Hit> run_at(const QPointF& place) const;
  /// Fraction of its plot that the cycle times cover; 0 without curves.
  double height_of_times() const;
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 signals:
  void run_clicked(std::size_t curve, std::size_t point);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  struct Layout;
  Layout lay_out() const;
  void draw_head(QPainter& painter, const Layout& layout) const;
  void draw_plot(QPainter& painter, const Layout& layout, bool is_error) const;
  void draw_settings_axis(QPainter& painter, const Layout& layout) const;
  void draw_curve(QPainter& painter, const Layout& layout, std::size_t index, bool is_error) const;
  /// Label above the line of the bound, if there is one.
  QRectF bound_label(const Layout& layout) const;
  QString bound_text() const;
  void draw_recorded(QPainter& painter, const Layout& layout, bool is_error) const;
  /// Labels above or below their lines, where they hide the least.
  std::vector<QRectF> recorded_labels(const Layout& layout, bool is_error) const;
  std::vector<QLineF> curve_lines(const Layout& layout, bool is_error) const;
  QString recorded_text(std::size_t index, bool is_error) const;
  /// Labels the recommended run of each curve.
  void draw_labels(QPainter& painter, const Layout& layout, bool is_error) const;
  /// Label next to a marker, where it hides the least.
  QRectF free_label(const Layout& layout, const QPointF& at, const QSizeF& size, bool is_error,
                    const std::vector<QRectF>& taken) const;

  QString title_;
  QString details_;
  StudyCurves study_;
};

}  // namespace feedscope::ui
