#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/analysis/path_deviation.h"
#include "core/drives/drive_response.h"

namespace feedscope {

/// The place where the axes are farthest from the programmed path.
struct ActualPlace {
  double error = 0;       ///< distance of the actual position from the nearest programmed point [mm]
  double of_control = 0;  ///< the same of the set position at that instant: what the control does [mm]
  double time = 0;        ///< [s]
  std::uint32_t line = 0;
  Vec3 position = Vec3::Zero();    ///< actual [mm]
  Vec3 programmed = Vec3::Zero();  ///< the nearest programmed point [mm]
};

/// What the drives make of a run.
struct ActualFigures {
  Vec3 largest_following_error = Vec3::Zero();  ///< by coordinate, absolute [mm]
  ActualPlace worst;                            ///< on cuts; rapids do not count
  double mean_contour_error = 0;                ///< over the time of the cuts [mm]
};

/// Looks at the middle of at least two equal parts of every span, each 2 ms at most, far below the time in
/// which drives answer. Throws Cancelled.
ActualFigures actual_figures(const DriveResponse& response, Progress* progress = nullptr);

/// Contour errors of actual positions at instants in order.
class ActualErrors {
 public:
  /// `trajectory` must outlive this.
  explicit ActualErrors(const Trajectory& trajectory)
      : trajectory_(trajectory), deviation_(*trajectory.path().programmed()) {}

  /// Nearest programmed point of `position`, while `element` is under way.
  PathDeviation::Foot foot(const Vec3& position, std::uint32_t element);
  /// Its distance [mm].
  double at(const Vec3& position, std::uint32_t element);

 private:
  const Trajectory& trajectory_;
  PathDeviation deviation_;
  std::size_t last_ = 0;  ///< segment of the foot before
};

/// What the axes do at one instant.
struct ActualSample {
  ActualMotion motion;
  double contour_error = 0;  ///< distance of the actual position from the nearest programmed point [mm]
};

/// Samples at instants that never fall.
class ActualSampler {
 public:
  /// `from`: the first instant [s]. `response` must outlive this.
  explicit ActualSampler(const DriveResponse& response, double from = 0)
      : walk_(response, from), errors_(response.trajectory()) {}
  /// `state`: of the trajectory.
  ActualSample at(const State& state);

 private:
  ActualWalk walk_;
  ActualErrors errors_;
};

/// A column of CSV, and of samples in Python, that a machine with drives adds.
struct ActualColumn {
  std::string_view name;                        ///< with its unit: "actual_x_mm"
  double (*of)(const ActualSample&) = nullptr;  ///< in that unit
};
std::span<const ActualColumn> actual_columns();

}  // namespace feedscope
