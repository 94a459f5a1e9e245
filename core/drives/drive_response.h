#pragma once

// Room `drives`: what the axes do with the set values. The position loops of the drives answer a Trajectory
// in closed form: actual position, following error, backlash and friction at reversals.

#include <array>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/drives/axis_steps.h"
#include "core/drives/reversal.h"
#include "core/drives/set_walk.h"
#include "core/machine/machine.h"

namespace feedscope {

/// Actual motion of the slides at one instant.
struct ActualMotion {
  Vec3 position;         ///< [mm]
  Vec3 velocity;         ///< of the motors [mm/s]
  Vec3 following_error;  ///< set minus actual position [mm]
};

/// Drives of the axes that move X, Y and Z, in this order.
struct AxisDrives {
  std::array<DriveLaw, 3> laws;
  std::array<Reversal, 3> slides;

  AxisDrives() = default;
  /// Throws InputError with drive_problem().
  explicit AxisDrives(const Machine& machine);
};

/// Whether any axis of the machine does not follow its set values exactly.
bool has_drives(const Machine& machine);

/// Actual positions of the axes along a trajectory, from standstill: response of the linear drives in closed
/// form, span by span. Stores the state at every 32nd span, so any instant costs at most as many steps; use
/// an ActualWalk for many instants in order.
class DriveResponse {
 public:
  /// Passes over the trajectory once and shares it. Throws Cancelled, and InputError as AxisDrives does.
  DriveResponse(std::shared_ptr<const Trajectory> trajectory, const Machine& machine,
                Progress* progress = nullptr);

  const Trajectory& trajectory() const { return *trajectory_; }
  /// Whether no axis has backlash or friction at reversals.
  bool is_rigid() const;
  /// Motion at `time`, clamped to the trajectory [s].
  ActualMotion at(double time) const;

 private:
  friend class ActualWalk;
  struct Start {
    double time = 0;
    std::array<MotorMotion, 3> motors;
    std::array<Reversal, 3> slides;
  };
  const Start& start_before(double time) const;

  std::shared_ptr<const Trajectory> trajectory_;
  std::shared_ptr<const AxisDrives> drives_;
  std::vector<Start> starts_;
};

/// Actual motion at instants that never decrease, in constant time on average.
class ActualWalk {
 public:
  /// `from`: the first instant [s]. `response` must outlive this.
  explicit ActualWalk(const DriveResponse& response, double from = 0);
  /// Starts at the beginning of a trajectory; both must outlive this.
  ActualWalk(const Trajectory& trajectory, const AxisDrives& drives);
  /// `time` [s]: not before that of the previous call.
  ActualMotion at(double time);
  /// As at(), within the current span.
  ActualMotion within_span(double time);

  /// State between motors and slides at the last requested instant.
  struct Slides {
    std::array<Reversal, 3> slides;
    double seen = 0;  ///< time after the start of the span [s]
  };
  Slides slides() const { return {slides_, seen_}; }
  /// Returns to an earlier instant of the span.
  void go_back(const Slides& to) {
    slides_ = to.slides;
    seen_ = to.seen;
  }

  /// Time until each motor has been within `window` [mm] of its set position, if these stay as at the start
  /// of the span, or at the end of the last one [s].
  double settling_time(double window) const;
  /// Keeps the set positions there for `time` [s]; does nothing after the last span.
  void rest(double time);

  bool done() const { return set_.done(); }
  /// Current span.
  const SetSpan& span() const { return set_.span(); }
  void next_span();

 private:
  friend class DriveResponse;

  const AxisDrives& drives_;
  SetWalk set_;
  std::array<MotorMotion, 3> motors_;  ///< at the start of the span
  std::array<Reversal, 3> slides_;     ///< at `seen_` after its start
  AxisSteps whole_;                    ///< to the end of the span
  AxisSteps within_;                   ///< to the last requested instant
  double seen_ = 0;                    ///< [s]
};

}  // namespace feedscope
