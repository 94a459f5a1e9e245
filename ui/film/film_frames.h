#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QRectF>
#include <cstddef>
#include <memory>
#include <optional>

#include "ui/film/film_times.h"
#include "ui/report/charts_page.h"
#include "ui/report/pictures.h"
#include "ui/report/scene_picture.h"

class QPainter;

namespace feedscope::ui {

/// Contents of a film besides its times.
struct FilmLook {
  PictureRequest picture;       ///< size, pixel ratio and theme
  std::optional<double> trail;  ///< of the run's time after the tool [s]; 0: none; no value: 2 s of the film
  bool charts = false;          ///< of the filmed range, below the view
};

/// The frames of a film of the current run: the 3D view with the tool at each time and a trail after it,
/// below it time, feed and line, and the charts with a cursor. Built once, updated for each frame. The same
/// input gives the same frames. Needs a QApplication with the theme.
class FilmFrames {
  Q_DECLARE_TR_FUNCTIONS(FilmFrames)

 public:
  /// Throws InputError for a size out of bounds or too small for the contents.
  FilmFrames(const ReportInput& input, const FilmTimes& times, const FilmLook& look);
  ~FilmFrames();
  FilmFrames(const FilmFrames&) = delete;
  FilmFrames& operator=(const FilmFrames&) = delete;

  /// Frame `k` of times.frames(), without transparency.
  QImage frame(std::size_t k);

 private:
  const Run& run() const { return input_.run().shown->run; }
  void lay_out();
  void make_charts();
  void draw_caption(QPainter& painter, const State& state) const;
  void draw_charts(QPainter& painter, double time);

  ReportInput input_;
  FilmTimes times_;
  FilmLook look_;
  double text_scale_;
  ScenePicture scene_;
  std::unique_ptr<ChartsPage> charts_;  ///< null: none
  double charts_scale_ = 1;             ///< factor from layout to drawing
  // Parts of the frame, from above [1/96 inch].
  QRectF view_;
  QRectF caption_;
  QRectF below_;
};

}  // namespace feedscope::ui
