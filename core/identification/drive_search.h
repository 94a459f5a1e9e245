#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/progress.h"
#include "core/identification/drive_record.h"
#include "core/identification/fit_parameter.h"
#include "core/machine/axis_drive.h"

namespace feedscope {

/// Numbers of a drive during the search: logarithm of the gain [1/s], feed-forward, lag [ms]. The
/// feed-forward may leave 0 to 1 meanwhile.
using DrivePlace = Eigen::Vector3d;

AxisDrive drive_at(const DrivePlace& place);
DrivePlace place_of(const AxisDrive& drive);

/// Searches the drive that explains a record best, with some of its numbers fixed.
class DriveSearch {
 public:
  /// `free`: searched numbers; `held`: values of the others. The search throws Cancelled.
  DriveSearch(const FreeDriveNumbers& free, const DrivePlace& held, Progress* progress)
      : free_(free), held_(held), progress_(progress) {}

  /// Same search with number `which` also fixed, at its value in `place`.
  DriveSearch holding(std::size_t which, const DrivePlace& place) const;
  /// Best of many drives; some of them, of different shares of feed-forward, are refined.
  DrivePlace first_guess(const DriveRecord& record) const;
  /// Minimises the sum of squares from `start` in `most` evaluations. `delay`: as for
  /// DriveRecord::residuals().
  DrivePlace refined(const DriveRecord& record, const DrivePlace& start, int most, double delay = 0) const;

 private:
  DrivePlace minimised(const DriveRecord& record, const DrivePlace& start, int most, double delay) const;
  std::vector<DrivePlace> drives_that_lag(double lag_time) const;

  FreeDriveNumbers free_;
  DrivePlace held_;
  Progress* progress_;
};

/// Sum of the squares of the residuals [mm2].
double drive_cost(const DriveRecord& record, const DrivePlace& place, double delay = 0);

}  // namespace feedscope
