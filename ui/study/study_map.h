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
  std::vector<double> values;  ///< ascending, in that unit
};

/// The run with one value of each setting.
struct StudyMapCell {
  double time = 0;   ///< cycle time [s]
  double error = 0;  ///< largest contour error [mm]
  bool possible = true;
  std::size_t lines_not_run = 0;  ///< refused by the control
  bool best = false;              ///< recommended_marks()
};

/// All runs of one model on one machine with equal further settings.
struct StudyMap {
  QString name;                     ///< difference from the other maps
  std::vector<StudyMapCell> cells;  ///< one for each pair of values; the first setting varies fastest
};

/// A study of at least two settings: the first two are the axes, the others distinguish the maps.
struct StudyMaps {
  StudyMapAxis x;
  StudyMapAxis y;
  std::optional<double> within;  ///< bound of the contour error [mm]
  bool actual = false;           ///< errors_are_actual()
  std::vector<StudyMap> maps;
};

/// `study` has at least two sweeps.
StudyMaps study_maps(const Study& study);

/// Lines with the contour error `level` [mm], interpolated between neighbouring cells, in columns and rows of
/// the map, with (0, 0) at the centre of the first cell. No lines next to cells of impossible runs.
std::vector<QLineF> contour_pieces(const StudyMap& map, std::size_t columns, double level);

/// Maps side by side on one scale: a cell for each run, coloured by its cycle time, with lines of equal
/// contour error, and a ring around the recommended run.
class StudyMapPicture {
 public:
  static constexpr int most_colours = 8;  ///< of the scale

  StudyMapPicture(QString title, QString details, StudyMaps study, const QFont& font);

  /// Size at which the cells of this many maps are easily readable, and the smallest size [pixels].
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
  /// Returns the end of its sample.
  double paint_scale(QPainter& painter, const QRectF& area) const;

  QString title_;
  QString details_;
  StudyMaps study_;
  QFont font_;
  Ticks times_;
  std::vector<double> levels_;  ///< of the contour error [mm]
};

}  // namespace feedscope::ui
