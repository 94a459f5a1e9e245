#pragma once

#include <QWidget>
#include <vector>

#include "core/analysis/circularity/circular_test.h"

class QPainter;

namespace feedscope::ui {

/// Circular tests as polar plots: the nominal circle, and the path of both directions with its radial
/// deviations enlarged to one scale for all plots, which is written as the distance of two circles of the
/// grid. Below each its values.
class PolarPlot : public QWidget {
  Q_OBJECT

 public:
  explicit PolarPlot(QWidget* parent = nullptr);

  /// `title`: what was tested, `details`: on which path and machine.
  void set_tests(const QString& title, const QString& details, std::vector<CircularTest> tests);
  /// What stands there instead while there are no tests.
  void set_hint(const QString& hint);
  const std::vector<CircularTest>& tests() const { return tests_; }
  /// Distance of two circles of the grid [mm].
  double division() const { return division_; }
  /// Whether the values stand in the widget as well: not beside a table that has them. At first they do.
  void show_values(bool shown);
  /// `values`: stand beside or below each plot.
  void draw(QPainter& painter, const QRectF& area, bool values = true) const;
  QSize minimumSizeHint() const override;
  /// That a picture needs to be read.
  QSize least_picture() const;
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Frame;

  void draw_test(QPainter& painter, const QRectF& cell, const CircularTest& test,
                 const QStringList& values) const;
  void draw_grid(QPainter& painter, const Frame& frame, const CircularTest& test) const;
  void draw_pass(QPainter& painter, const Frame& frame, const CircularTest& test,
                 const CirclePass& pass) const;
  void draw_start(QPainter& painter, const Frame& frame, const CircularTest& test) const;
  /// Directions and scale, on as many lines as they need from `first_line` on; returns their lower end.
  double draw_legend(QPainter& painter, const QRectF& first_line) const;
  int columns() const;

  QString hint_;
  bool values_shown_ = true;
  QString title_;
  QString details_;
  std::vector<CircularTest> tests_;
  double division_ = 0.01;  ///< [mm]
};

/// Values of a test, a line each: "G 31.6 µm (least squares 32.5 µm)".
QStringList circular_values(const CircularTest& test);
/// What a test is: "R 30 mm, 6 000 mm/min, XY", behind the lines of a circle of a program.
QString circular_heading(const CircularTest& test);
/// "12", "12–15": of a circle of a program.
QString circle_lines(const CirclePass& pass);

}  // namespace feedscope::ui
