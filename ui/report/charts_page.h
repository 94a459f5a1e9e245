#pragma once

#include <QWidget>

#include "ui/charts/charts_panel.h"
#include "ui/report/report_input.h"

class QLabel;

namespace feedscope::ui {

/// Feed with what limits it, acceleration and jerk of a run for a picture; a line above names the run.
class ChartsPage : public QWidget {
 public:
  ChartsPage();

  void set_run(const Run& run);
  /// Run `row` of `input`, the others behind it.
  void set_runs(const ReportInput& input, std::size_t row);
  /// Points at an instant of the run [s], with the values there in the headers.
  void set_cursor(double time);
  void hide_title();
  /// The colour behind titles and legends.
  void set_background(const QColor& colour);
  /// How many charts there are on it, one above the other.
  int count() const;
  /// Lays the page out; `resolution`: columns that the curves have for each pixel.
  void prepare(const QSize& size, double resolution = 1);
  /// What prepare() has laid out, as vectors. `background`: behind title and legends too.
  void draw(QPainter& painter, bool background = true);

 private:
  Cursor cursor_;
  ViewRange range_;
  QLabel* title_;
  ChartsPanel* charts_;
};

}  // namespace feedscope::ui
