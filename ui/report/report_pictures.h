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

/// A picture of a report: painted into a rectangle from 0, 0, rasters with `pixel_ratio` pixels to a unit.
struct ReportPicture {
  QSizeF size;  ///< units of 1/96 inch
  bool raster = false;
  std::function<void(QPainter&, double pixel_ratio)> paint;
};

/// Makes a picture of another size.
using PictureMaker = std::function<ReportPicture(const QSizeF& size)>;

/// A picture that takes what its page has left.
struct ElasticPicture {
  PictureMaker make;
  double least = 0;    ///< height [1/96 inch]
  double largest = 0;  ///< height [1/96 inch]
};

/// The pictures that the blocks of a report name, by these names.
class ReportPictures {
 public:
  explicit ReportPictures(Progress* progress = nullptr) : progress_(progress) {}
  /// Adds a picture and gives the HTML that shows it.
  QString add(const QString& name, ReportPicture picture, const QString& description);
  /// The same of a picture that begins with its largest height and may be made lower.
  QString add_elastic(const QString& name, double width, ElasticPicture picture, const QString& description);
  const std::map<QString, ElasticPicture>& elastic() const { return elastic_; }
  /// Makes an elastic one again.
  void resize(const QString& name, double height);
  /// What a picture shows, for those who cannot see it.
  QString description(const QString& name) const;
  const std::map<QString, ReportPicture>& all() const { return pictures_; }
  /// Paints one of them; throws Cancelled. A name that is none paints nothing.
  void paint(const QString& name, QPainter& painter, double pixel_ratio) const;

 private:
  Progress* progress_;
  mutable std::size_t painted_ = 0;
  std::map<QString, ReportPicture> pictures_;
  std::map<QString, ElasticPicture> elastic_;
  std::map<QString, QString> descriptions_;
};

/// Width of what stands between the margins of a report [1/96 inch].
inline constexpr double report_width = 672;

/// `html` with the figures in it numbered in their order, and references to them as links.
QString with_figure_numbers(const QString& html);
/// " (Figure 3)" of the figure that shows the picture with this name; nothing where the report has none.
QString figure_reference(const QString& picture);
/// A picture over the whole width with its caption, both HTML.
QString figure(const QString& picture, const QString& caption);
/// Pictures with their captions beside each other, two a row; empty for none.
QString close_up_table(const std::vector<std::pair<QString, QString>>& pictures);
/// Two blocks beside each other, the left one `share` percent of the width.
QString two_columns(const QString& left, const QString& right, int share);
/// Of a narrow text or picture beside a wide one [%].
inline constexpr int narrow_share = 34;
/// The size of a picture there.
QSizeF close_up_size();

/// The current run at a slow place from above or obliquely, the place marked.
ReportPicture close_up(const ReportInput& input, const SlowPlace& place, const QSizeF& size);
/// What a ScenePicture of a close-up is made of, and its camera and marks.
ReportInput at_place(ReportInput input, const SlowPlace& place);
void show_place(ScenePicture& picture, const SlowPlace& place, const QSizeF& size, const SceneScale& scale);
/// Without a legend of lines, which would lie over them in a close-up.
SceneTexts without_line_names(SceneTexts texts);

/// What the label of a note, counted from 0, begins with where the notes have a table: "1 · ".
QString note_number(std::size_t note);

/// The input with its current run alone, unless colours compare it with another one.
ReportInput without_other_runs(ReportInput input);

/// The annotations of the current run that belong to what it does between two times [s]: what a close-up
/// shows of them.
std::vector<Annotation> annotations_between(const ReportInput& input, double from, double to);

// Blocks with pictures as HTML.

/// The current run in 3D as `view_block`, and the charts of one run, so high [1/96 inch].
QString run_view(const ReportInput& input, ReportPictures& pictures, double height,
                 const QString& caption = {});
/// The current run in 3D; its height is what the page has left.
QString elastic_view(const ReportInput& input, ReportPictures& pictures, const QString& caption);
QString run_charts(const ReportInput& input, std::size_t row, ReportPictures& pictures, double height,
                   const QString& caption = {});

/// The current run in 3D, with the annotations, coloured as the input says.
QString view_block(const ReportInput& input, ReportPictures& pictures);
/// The same from the same place, coloured in another way.
QString coloured_view(const ReportInput& input, Colouring colouring, const QString& name,
                      const QString& alternative, const QString& caption, ReportPictures& pictures);
/// The same by limiting cause.
QString cause_view_block(const ReportInput& input, ReportPictures& pictures);
/// Feed with its causes, acceleration and jerk of every run.
QString charts_block(const ReportInput& input, ReportPictures& pictures);
/// The runs as bars by limiting cause.
QString bars_block(const ReportInput& input, ReportPictures& pictures);
/// The places that lose most time, and why.
QString slow_places_block(const ReportInput& input);
/// Close-ups of the same places.
QString slow_place_views_block(const ReportInput& input, ReportPictures& pictures);
/// The annotations as a list; empty without any.
QString notes_block(const ReportInput& input);

}  // namespace feedscope::ui
