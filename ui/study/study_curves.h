#pragma once

#include <QColor>
#include <QString>
#include <optional>
#include <vector>

#include "core/analysis/study/study.h"

namespace feedscope::ui {

/// One run of a study in a StudyChart.
struct StudyPoint {
  double value = 0;  ///< of the swept setting, in its unit
  double time = 0;   ///< cycle time [s]
  double error = 0;  ///< largest contour error [mm]
};

struct StudyCurve {
  QString name;
  std::vector<StudyPoint> points;
  std::vector<std::size_t> best;  ///< recommended_marks()
};

/// A machine's recorded time for the program, drawn across the whole range of the setting.
struct RecordedTime {
  QString name;  ///< of the trace
  QColor colour;
  double time = 0;   ///< cycle time [s]
  double error = 0;  ///< largest distance from the programmed path [mm]
};

/// Contents of a StudyChart.
struct StudyCurves {
  QString title;  ///< of the setting, in the window's language
  QString unit;   ///< "" for a plain number
  bool logarithmic = false;
  std::optional<double> within;  ///< bound of the contour error [mm]
  bool actual = false;           ///< errors_are_actual()
  std::vector<StudyCurve> curves;
  std::vector<RecordedTime> recorded = {};
};

/// Whether the contour errors that decide (deciding_error) are those of the drives in all runs.
bool errors_are_actual(const Study& study);

/// Common part of the runs in one curve or map of a study: model, machine, the tolerance if it differs within
/// the study, the values of all sweeps after the second.
QString family_name(const Study& study, const StudyRun& run);

/// `study` has one sweep; with two, use study_maps().
StudyCurves study_curves(const Study& study);

}  // namespace feedscope::ui
