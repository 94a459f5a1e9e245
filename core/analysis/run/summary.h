#pragma once

#include <optional>
#include <vector>

#include "core/analysis/contour/actual_figures.h"
#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/load/load_figures.h"
#include "core/analysis/rotary/rotary_figures.h"
#include "core/analysis/run/axis_peaks.h"
#include "core/base/progress.h"
#include "core/machine/axis_vector.h"
#include "core/toolpath/machine_path.h"
#include "core/toolpath/toolpath.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Figures of a run.
struct Summary {
  double cycle_time = 0;             ///< [s]
  double programmed_time = 0;        ///< programmed length over programmed feed, plus rapids and dwells [s]
  double mean_feed = 0;              ///< executed length over cycle time minus dwells [mm/s]
  double max_contour_error = 0;      ///< as ContourErrors::largest: executed from programmed path [mm]
  double cutting_contour_error = 0;  ///< of feed motions only [mm]
  /// Largest distance between a programmed corner, or a point that the control omits, and the executed path,
  /// as measured by largest_corner_distance(): bounded by a contour tolerance [mm].
  double max_corner_distance = 0;
  ContourPlace worst_place;  ///< of max_contour_error; all 0 if the run never leaves the path
  double peak_feed = 0;      ///< [mm/s]
  AxisVector<AxisPeaks> axes;
  /// By cause_index(); adds up to cycle_time up to rounding: less than 1e-14 of it counts as none [s].
  std::vector<double> time_by_cause;
  /// Time of ramp_down by cause_index() of the slower place ahead [s].
  std::vector<double> time_by_slower_place;
  NotCounted not_counted;               ///< events that take time on the machine but none here
  std::optional<ActualFigures> actual;  ///< of a machine with drives
  std::optional<LoadFigures> load;      ///< of a run with a load file
  /// Of a run in which rotary axes turn; the peaks above are then those of the tip.
  std::optional<RotaryFigures> rotary;
};

/// `toolpath`: of the trajectory; `rapid_speed`: per axis [mm/s]; `limits_jerk`: of the model; without, the
/// jerk of an axis has no largest value (NaN). Throws Cancelled when stopped.
Summary summarise(const Trajectory& trajectory, const Toolpath& toolpath, const Vec3& rapid_speed,
                  Progress* progress = nullptr, bool limits_jerk = true);

}  // namespace feedscope
