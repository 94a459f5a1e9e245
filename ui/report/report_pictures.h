#pragma once

#include <QSizeF>
#include <QString>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "ui/report/report_input.h"

class QPainter;

namespace feedscope::ui {

class ScenePicture;
struct SceneScale;

/// A picture of a report: painted into a rectangle from 0, 0, rasters with `pixel_ratio` pixels per unit.
struct ReportPicture {
  QSizeF size;  ///< units of 1/96 inch
  bool raster = false;
  std::function<void(QPainter&, double pixel_ratio)> paint;
};

/// Makes a picture for a given size.
using PictureMaker = std::function<ReportPicture(const QSizeF& size)>;

/// A picture that takes the rest of its page.
struct ElasticPicture {
  PictureMaker make;
  double least = 0;    ///< height [1/96 inch]
  double largest = 0;  ///< height [1/96 inch]
};

/// The pictures of a report's blocks, by the names that the blocks use.
class ReportPictures {
 public:
  explicit ReportPictures(Progress* progress = nullptr) : progress_(progress) {}
  /// Adds a picture and returns the HTML that shows it.
  QString add(const QString& name, ReportPicture picture, const QString& description);
  /// Adds a picture with its largest height, which may be reduced.
  QString add_elastic(const QString& name, double width, ElasticPicture picture, const QString& description);
  const std::map<QString, ElasticPicture>& elastic() const { return elastic_; }
  /// Makes an elastic picture of another height.
  void resize(const QString& name, double height);
  /// Description of a picture for people who cannot see it.
  QString description(const QString& name) const;
  const std::map<QString, ReportPicture>& all() const { return pictures_; }
  /// Paints a picture; throws Cancelled. An unknown name paints nothing.
  void paint(const QString& name, QPainter& painter, double pixel_ratio) const;

 private:
  Progress* progress_;
  mutable std::size_t painted_ = 0;
  std::map<QString, ReportPicture> pictures_;
  std::map<QString, ElasticPicture> elastic_;
  std::map<QString, QString> descriptions_;
};

/// Width between the margins of a report [1/96 inch].
inline constexpr double report_width = 672;

/// `html` with its figures numbered in order, and references to them as links.
QString with_figure_numbers(const QString& html);
/// " (Figure 3)" for the figure with this picture; nothing if the report does not contain it.
QString figure_reference(const QString& picture);
/// A picture over the whole width with its caption; both are HTML.
QString figure(const QString& picture, const QString& caption);
/// Pictures with their captions side by side, two in a row; empty for none.
QString close_up_table(const std::vector<std::pair<QString, QString>>& pictures);
/// Two blocks side by side, the left one `share` percent of the width.
QString two_columns(const QString& left, const QString& right, int share);
/// Width of a narrow text or picture next to a wide one [%].
inline constexpr int narrow_share = 34;
/// The size of a picture in close_up_table().
QSizeF close_up_size();

/// The current run at a slow place, seen from above or obliquely, with the place marked.
ReportPicture close_up(const ReportInput& input, const SlowPlace& place, const QSizeF& size);
/// The input of a ScenePicture for a close-up, with its camera and marks.
ReportInput at_place(ReportInput input, const SlowPlace& place);
void show_place(ScenePicture& picture, const SlowPlace& place, const QSizeF& size, const SceneScale& scale);
/// Without a legend of lines, which would cover them in a close-up.
SceneTexts without_line_names(SceneTexts texts);

/// Prefix of the label of a note, counted from 0, if the notes have a table: "1 · ".
QString note_number(std::size_t note);

/// `input` with its current run only, unless colours compare it with another one.
ReportInput without_other_runs(ReportInput input);

/// The annotations of the current run between two times [s], for a close-up.
std::vector<Annotation> annotations_between(const ReportInput& input, double from, double to);

// Blocks with pictures as HTML.

/// The current run in 3D as in view_block(), but with this height [1/96 inch].
QString run_view(const ReportInput& input, ReportPictures& pictures, double height,
                 const QString& caption = {});
/// The current run in 3D, as high as the rest of its page.
QString elastic_view(const ReportInput& input, ReportPictures& pictures, const QString& caption);
/// Charts of run `row` with this height [1/96 inch].
QString run_charts(const ReportInput& input, std::size_t row, ReportPictures& pictures, double height,
                   const QString& caption = {});

/// The current run in 3D with the annotations, coloured by the input.
QString view_block(const ReportInput& input, ReportPictures& pictures);
/// The same view with another colouring.
QString coloured_view(const ReportInput& input, Colouring colouring, const QString& name,
                      const QString& alternative, const QString& caption, ReportPictures& pictures);
/// The same view coloured by limiting cause.
QString cause_view_block(const ReportInput& input, ReportPictures& pictures);
/// Feed with its causes, acceleration and jerk of each run.
QString charts_block(const ReportInput& input, ReportPictures& pictures);
/// The runs as bars by limiting cause.
QString bars_block(const ReportInput& input, ReportPictures& pictures);
/// The places with the largest loss of time, and their causes.
QString slow_places_block(const ReportInput& input);
/// Close-ups of the same places.
QString slow_place_views_block(const ReportInput& input, ReportPictures& pictures);
/// The annotations as a list; empty without any.
QString notes_block(const ReportInput& input);

}  // namespace feedscope::ui
