#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/identification/fit_parameter.h"
#include "core/identification/identified_parameter.h"
#include "core/machine/axis_drive.h"
#include "core/trace/trace.h"

namespace feedscope {

/// What set and actual positions say of the drive of one axis: position gain, velocity feed-forward and lag
/// of the velocity loop, in this order.
struct DriveFit {
  char axis = 'X';
  std::array<IdentifiedParameter, drive_parameter_count> parameters;
  std::size_t samples = 0;     ///< that were compared; 0: the axis stands, or its positions are not recorded
  double following_error = 0;  ///< root mean square, less its mean [mm]
  double left = 0;             ///< the same of what the drive that was found does not explain [mm]
  bool explains = false;       ///< the drive explains the following errors
  /// Of the actual positions against the set ones, where it explains them clearly better than none; nothing
  /// is told then. Else 0 [s].
  double delay = 0;
  /// Which were looked for; the others stay at what they were begun with.
  FreeDriveNumbers free{true, true, true};
  bool of_first_order = false;  ///< a gain alone explains them as well: none of the three is told
};

/// The axes whose drives traces can tell, in the order X, Y, Z: those with set and actual positions.
std::string axes_with_drives(const std::vector<const Trace*>& traces);

/// Finds the drive of one axis from its recorded positions, whatever control made the set ones. The set
/// positions are answered by drives of many gains, shares of feed-forward and lags; the best ones are refined
/// by Levenberg-Marquardt steps on the sum of squares. How set positions run between samples is taken as the
/// record speaks for; where it does not, both ways are within the uncertainty.
///
/// The uncertainty is twice the standard deviation, the largest one of what the residuals, taken as
/// correlated from sample to sample, what the guess of the set position between samples, and what leaving out
/// each twelfth in turn say. A lag that makes no difference is taken as none. Nothing is told if the axis
/// hardly moves, or if more than a third of the following error is left over: a linear drive is then not what
/// moves it. Delays of the actual positions, of some samples to both sides, are tried too: where one explains
/// the record clearly better than none, nothing is told; where one explains it as well, its values are within
/// the uncertainty. Nor is anything told where the feed-forward would be outside 0 to 1. A response of first
/// order is one of a gain alone as well as of many gains with feed-forward and lag: none of the three is then
/// told, and the gain alone is used.
///
/// `start`: what a machine file has of the drive; it stays where nothing is told. `free`: what is looked for;
/// the rest is held at `start`, as none where that has no value. A gain is looked for where there is none to
/// hold, and all three where others than those that are held explain the record clearly better. Throws
/// Cancelled.
DriveFit fit_drive(const std::vector<const Trace*>& traces, char axis, const AxisDrive& start,
                   FreeDriveNumbers free = {true, true, true}, Progress* progress = nullptr);

/// Positions of one recording are all of one time or none: where one axis has a delay, nothing is
/// told of the others either.
void distrust_delayed(std::vector<DriveFit>& fits);

/// The drive with the values that were found.
AxisDrive found_drive(const DriveFit& fit, const AxisDrive& start);

}  // namespace feedscope
