#pragma once

#include <optional>
#include <vector>

#include "core/analysis/actual_figures.h"
#include "core/analysis/axis_peaks.h"
#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/load/load_figures.h"
#include "core/analysis/rotary_figures.h"
#include "core/base/progress.h"
#include "core/machine/axis_vector.h"
#include "core/toolpath/machine_toolpath.h"
#include "core/toolpath/toolpath.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Figures of a run.
struct Summary {
  double cycle_time = 0;         ///< [s]
  double programmed_time = 0;    ///< programmed length over programmed feed, rapids, dwells [s]
  double mean_feed = 0;          ///< executed length over cycle time less dwells [mm/s]
  double max_contour_error = 0;  ///< as ContourErrors::largest: of the executed from the programmed path [mm]
  double cutting_contour_error = 0;  ///< the same of feed motions alone, without rapids [mm]
  /// Largest distance of a programmed corner, or of a point that the control leaves out, from the executed
  /// path, as largest_corner_distance() measures it: what a contour tolerance bounds [mm].
  double max_corner_distance = 0;
  ContourPlace worst_place;  ///< where max_contour_error is; of a run that leaves the path nowhere all 0
  double peak_feed = 0;      ///< [mm/s]
  AxisVector<AxisPeaks> axes;
  /// By cause_index(); adds up to cycle_time but for rounding: less than 1e-14 of it is none [s].
  std::vector<double> time_by_cause;
  /// Of the time of ramp_down: by cause_index() of what sets the slower place ahead [s].
  std::vector<double> time_by_slower_place;
  NotCounted not_counted;               ///< what takes time on the machine and none here
  std::optional<ActualFigures> actual;  ///< of a machine with drives
  std::optional<LoadFigures> load;      ///< of a run with a load file
  /// Of a run in which rotary axes turn; the peaks above are then those of the tip.
  std::optional<RotaryFigures> rotary;
};

/// `toolpath`: that the trajectory runs; `rapid_speed` per axis [mm/s]. Throws Cancelled when stopped.
Summary summarise(const Trajectory& trajectory, const Toolpath& toolpath, const Vec3& rapid_speed,
                  Progress* progress = nullptr);

}  // namespace feedscope
