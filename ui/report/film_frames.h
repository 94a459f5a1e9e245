#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QRectF>
#include <cstddef>
#include <memory>
#include <optional>

#include "ui/report/charts_page.h"
#include "ui/report/film_times.h"
#include "ui/report/pictures.h"
#include "ui/report/scene_picture.h"

class QPainter;

namespace feedscope::ui {

/// What a film shows beside the instants.
struct FilmLook {
  PictureRequest picture;       ///< size, pixel ratio and theme
  std::optional<double> trail;  ///< behind the tool, of the run [s]; 0: none; no value: 2 s of the film
  bool charts = false;          ///< of the stretch, below the view
};

/// The frames of a film of the current run: the 3D view with the tool where it is at the time, a trail behind
/// the tool, below it time, feed and line, and the charts with a cursor. Made once, moved for each frame. The
/// same input gives the same frames. Needs a QApplication with the theme.
class FilmFrames {
  Q_DECLARE_TR_FUNCTIONS(FilmFrames)

 public:
  /// Throws InputError where the size is out of bounds or too small for what is to be in it.
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
  std::unique_ptr<ChartsPage> charts_;  ///< null: there are none
  double charts_scale_ = 1;             ///< how much larger they are drawn than laid out
  // Parts of the frame, from above [1/96 inch].
  QRectF view_;
  QRectF caption_;
  QRectF below_;
};

}  // namespace feedscope::ui
