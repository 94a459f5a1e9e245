#pragma once

#include <memory>

#include "core/analysis/contour/path_deviation.h"
#include "core/drives/drive_response.h"

namespace feedscope {

/// Motion and contour error of the axes at one instant.
struct ActualSample {
  ActualMotion motion;
  double contour_error = 0;  ///< distance of the actual position from the nearest programmed point [mm]
  /// The error counts: a feed motion is commanded, and the nearest programmed point is not on a rapid, where
  /// the axes may still lag.
  bool cuts = true;
};

/// The path that the axes of a machine with drives run, as opposed to the set path that is commanded.
class ActualPath {
 public:
  /// Passes over the trajectory once, as DriveResponse does. Throws Cancelled, and InputError as AxisDrives
  /// does.
  ActualPath(std::shared_ptr<const Trajectory> trajectory, const Machine& machine,
             Progress* progress = nullptr);

  const Trajectory& trajectory() const { return response_.trajectory(); }
  const DriveResponse& response() const { return response_; }
  /// `state`: of the trajectory. Walks over up to 32 spans; use an ActualSampler for many instants in order.
  ActualSample at(const State& state) const;
  /// Distance of the set position from the nearest programmed point: the control's share [mm].
  double set_contour_error(const State& state) const;

 private:
  friend class ActualErrors;

  DriveResponse response_;
  PathDeviation deviation_;
};

/// Contour errors of actual positions, at instants in order.
class ActualErrors {
 public:
  /// `path` must outlive this.
  explicit ActualErrors(const ActualPath& path)
      : trajectory_(path.trajectory()), deviation_(path.deviation_) {}

  /// Nearest programmed point of `position`, while `element` is under way.
  PathDeviation::Foot foot(const Vec3& position, std::uint32_t element);
  /// Whether a feed motion is commanded while `element` is under way.
  bool is_cut(std::uint32_t element) const;
  /// Whether the distance of `foot` counts, as in ActualSample::cuts.
  bool is_of_cut(const PathDeviation::Foot& foot, std::uint32_t element) const;
  /// Distance of `position` from its nearest programmed point [mm].
  double at(const Vec3& position, std::uint32_t element);

 private:
  const Trajectory& trajectory_;
  PathDeviation deviation_;
  std::size_t last_ = 0;  ///< segment of the previous foot
};

/// Samples at instants that never decrease.
class ActualSampler {
 public:
  /// `from`: the first instant [s]. `path` must outlive this.
  explicit ActualSampler(const ActualPath& path, double from = 0)
      : walk_(path.response(), from), errors_(path) {}
  /// `state`: of the trajectory.
  ActualSample at(const State& state);

 private:
  ActualWalk walk_;
  ActualErrors errors_;
};

}  // namespace feedscope
