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

/// Drive of one axis identified from set and actual positions: position gain, velocity feed-forward and lag
/// of the velocity loop, in this order.
struct DriveFit {
  char axis = 'X';
  std::array<IdentifiedParameter, drive_parameter_count> parameters;
  std::size_t samples = 0;     ///< compared; 0: the axis does not move, or its positions are not recorded
  double following_error = 0;  ///< root mean square, without its mean [mm]
  double left = 0;             ///< part of it that the identified drive does not explain [mm]
  bool explains = false;       ///< the drive explains the following errors
  /// Delay of the actual positions against the set ones [s], if it explains them clearly better; nothing is
  /// determined then. Else 0.
  double delay = 0;
  /// Searched numbers; the others keep their start values.
  FreeDriveNumbers free{true, true, true};
  bool of_first_order = false;  ///< a gain alone explains them as well: none of the three is determined
};

/// Axes whose drives are identifiable from traces, in the order X, Y, Z: those with set and actual positions.
std::string axes_with_drives(const std::vector<const Trace*>& traces);

/// Identifies the drive of one axis from its recorded positions, whatever control set them. Simulates the
/// response of drives with many gains, shares of feed-forward and lags to the set positions, and refines the
/// best by Levenberg-Marquardt steps on the sum of squares. The course of set positions between samples is
/// the one that fits the record; if neither is better, both are within the uncertainty.
///
/// The uncertainty is twice the standard deviation, the largest one from the residuals, taken as correlated
/// from sample to sample, from the guess of the set position between samples, and from omitting each twelfth
/// in turn. A lag without effect counts as none. Nothing is determined if the axis hardly moves, or if more
/// than a third of the following error remains: its motion is not that of a linear drive. Delays of the
/// actual positions by some samples in both directions are also tried: if one explains the record clearly
/// better than none, nothing is determined; if one explains it as well, its values are within the
/// uncertainty. Nor is anything determined if the feed-forward would be outside of 0 to 1. A first-order
/// response fits a gain alone as well as many gains with feed-forward and lag: then none of the three is
/// determined, and the gain alone is used.
///
/// `start`: drive from the machine file, used where nothing is determined. `free`: searched numbers; the
/// others are fixed at `start`, as none without a value. The gain is searched if `start` has none, and all
/// three if values other than the fixed ones explain the record clearly better. Throws Cancelled.
DriveFit fit_drive(const std::vector<const Trace*>& traces, char axis, const AxisDrive& start,
                   FreeDriveNumbers free = {true, true, true}, Progress* progress = nullptr);

/// The positions of one recording are all synchronous or none are: if one axis has a delay, nothing is
/// determined for the others either.
void distrust_delayed(std::vector<DriveFit>& fits);

/// Drive with the identified values.
AxisDrive found_drive(const DriveFit& fit, const AxisDrive& start);

}  // namespace feedscope
