#pragma once

#include <QWidget>

#include "ui/charts/charts_panel.h"
#include "ui/report/report_input.h"

class QLabel;

namespace feedscope::ui {

/// Charts of a run for a picture: feed with its limiting causes, acceleration and jerk; a line above names
/// the run.
class ChartsPage : public QWidget {
 public:
  ChartsPage();

  void set_run(const Run& run);
  /// Run `row` of `input`, with the others under it.
  void set_runs(const ReportInput& input, std::size_t row);
  /// Points at an instant of the run [s], with the values there in the headers.
  void set_cursor(double time);
  void hide_title();
  /// Background colour of titles and legends.
  void set_background(const QColor& colour);
  /// Number of charts, one above the other.
  int count() const;
  /// Lays the page out; `resolution`: curve columns per pixel.
  void prepare(const QSize& size, double resolution = 1);
  /// Draws the layout of prepare() as vectors. `background`: of titles and legends too.
  void draw(QPainter& painter, bool background = true);

 private:
  Cursor cursor_;
  ViewRange range_;
  QLabel* title_;
  ChartsPanel* charts_;
};

}  // namespace feedscope::ui
