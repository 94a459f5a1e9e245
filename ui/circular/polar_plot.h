#pragma once

#include <QWidget>
#include <vector>

#include "core/analysis/circularity/circular_test.h"

class QPainter;

namespace feedscope::ui {

/// Circular tests as polar plots: the nominal circle, and the path of both directions. Radial deviations are
/// enlarged by one scale for all plots, given as the distance of two circles of the grid. The values are
/// below each plot.
class PolarPlot : public QWidget {
  Q_OBJECT

 public:
  explicit PolarPlot(QWidget* parent = nullptr);

  /// `title`: the test, `details`: path and machine.
  void set_tests(const QString& title, const QString& details, std::vector<CircularTest> tests);
  /// Text shown without tests.
  void set_hint(const QString& hint);
  const std::vector<CircularTest>& tests() const { return tests_; }
  /// Distance of two circles of the grid [mm].
  double division() const { return division_; }
  /// Whether the widget shows the values as well; not needed next to a table of them. Initially it does.
  void show_values(bool shown);
  /// `values`: draw them next to or below each plot.
  void draw(QPainter& painter, const QRectF& area, bool values = true) const;
  QSize minimumSizeHint() const override;
  /// Smallest readable size of a picture.
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
  /// Draws directions and scale, on as many lines as they need, starting at `first_line`; returns their lower
  /// end.
  double draw_legend(QPainter& painter, const QRectF& first_line) const;
  int columns() const;

  QString hint_;
  bool values_shown_ = true;
  QString title_;
  QString details_;
  std::vector<CircularTest> tests_;
  double division_ = 0.01;  ///< [mm]
};

/// Values of a test, one for each line: "G 31.6 µm (least squares 32.5 µm)".
QStringList circular_values(const CircularTest& test);
/// Description of a test: "R 30 mm, 6 000 mm/min, XY"; for a circle of a program, after its lines.
QString circular_heading(const CircularTest& test);
/// Lines of a circle of a program: "12", "12–15".
QString circle_lines(const CirclePass& pass);

}  // namespace feedscope::ui
