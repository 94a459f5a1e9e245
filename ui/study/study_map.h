#pragma once

#include <QFont>
#include <QLineF>
#include <QSize>
#include <QString>
#include <optional>
#include <vector>

#include "core/analysis/study/study.h"
#include "core/base/ticks.h"

class QPainter;

namespace feedscope::ui {

/// One of the two settings of a map.
struct StudyMapAxis {
  QString title;               ///< in the window's language
  QString unit;                ///< "" for a plain number
  std::vector<double> values;  ///< rising, in that unit
};

/// The run with one value of either setting.
struct StudyMapCell {
  double time = 0;   ///< cycle time [s]
  double error = 0;  ///< largest contour error [mm]
  bool possible = true;
  std::size_t lines_not_run = 0;  ///< that the control refuses
  bool fastest = false;           ///< within the bound, as fastest_marks()
};

/// All runs of one model on one machine with the same further settings.
struct StudyMap {
  QString name;                     ///< what tells it apart from the others
  std::vector<StudyMapCell> cells;  ///< one a pair of values, the first setting changes from cell to cell
};

/// A study of two settings or more: the first two are the axes, the others tell the maps apart.
struct StudyMaps {
  StudyMapAxis x;
  StudyMapAxis y;
  std::optional<double> within;  ///< bound of the contour error [mm]
  std::vector<StudyMap> maps;
};

/// `study` has two sweeps or more.
StudyMaps study_maps(const Study& study);

/// Where the contour error is `level` [mm], interpolated between neighbouring cells: pieces of lines in
/// columns and rows of the map, (0, 0) in the middle of the first cell. Nothing next to cells of runs that
/// are not possible.
std::vector<QLineF> contour_pieces(const StudyMap& map, std::size_t columns, double level);

/// Maps side by side on one scale: a cell for each run, coloured by its cycle time, lines of equal contour
/// error across them, the fastest run within the bound ringed.
class StudyMapPicture {
 public:
  static constexpr int most_colours = 8;  ///< of the scale

  StudyMapPicture(QString title, QString details, StudyMaps study, const QFont& font);

  /// At which the cells of this many maps are easy to read, and the least [pixels].
  static QSize natural_size(std::size_t maps);
  static QSize least_size(std::size_t maps);
  void paint(QPainter& painter, const QSize& size) const;
  /// Bounds between the colours of the cycle time [s].
  const Ticks& time_ticks() const { return times_; }

 private:
  struct Place;
  QColor colour_of(double time) const;
  QString best_text(const StudyMap& map) const;
  void paint_map(QPainter& painter, const StudyMap& map, const QRectF& area) const;
  void paint_cells(QPainter& painter, const StudyMap& map, const Place& place) const;
  void paint_contours(QPainter& painter, const StudyMap& map, const Place& place) const;
  void paint_times(QPainter& painter, const StudyMap& map, const Place& place) const;
  void paint_legend(QPainter& painter, const QRectF& area) const;
  /// Returns where its sample ends.
  double paint_scale(QPainter& painter, const QRectF& area) const;

  QString title_;
  QString details_;
  StudyMaps study_;
  QFont font_;
  Ticks times_;
  std::vector<double> levels_;  ///< of the contour error [mm]
};

}  // namespace feedscope::ui
