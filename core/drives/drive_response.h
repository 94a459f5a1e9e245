#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/drives/axis_steps.h"
#include "core/drives/reversal.h"
#include "core/drives/set_walk.h"
#include "core/machine/machine.h"

namespace feedscope {

/// What the slides do at one instant.
struct ActualMotion {
  Vec3 position;         ///< [mm]
  Vec3 velocity;         ///< of the motors [mm/s]
  Vec3 following_error;  ///< set position less actual position [mm]
};

/// The drives of the axes that move X, Y and Z, in this order.
struct AxisDrives {
  std::array<DriveLaw, 3> laws;
  std::array<Reversal, 3> slides;

  AxisDrives() = default;
  /// Throws InputError as drive_problem() says.
  explicit AxisDrives(const Machine& machine);
};

/// Whether any axis of the machine does not follow its set values exactly.
bool has_drives(const Machine& machine);

/// Where the axes are where a trajectory asks them to be elsewhere, from standstill on: the answer of the
/// linear drives in closed form, span by span. Keeps the state of every 32nd span, so that any instant costs
/// as many steps at most; for many in order use an ActualWalk.
class DriveResponse {
 public:
  /// One pass over the trajectory, which this shares. Throws Cancelled, and InputError as AxisDrives.
  DriveResponse(std::shared_ptr<const Trajectory> trajectory, const Machine& machine,
                Progress* progress = nullptr);

  const Trajectory& trajectory() const { return *trajectory_; }
  /// Whether no axis has backlash or friction at reversals.
  bool is_rigid() const;
  /// At `time`, clamped to the trajectory [s].
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

/// Actual motion at instants that never fall: each takes constant time on average.
class ActualWalk {
 public:
  /// `from`: the first instant [s]. `response` must outlive this.
  explicit ActualWalk(const DriveResponse& response, double from = 0);
  /// From the start of a trajectory; both must outlive this.
  ActualWalk(const Trajectory& trajectory, const AxisDrives& drives);
  /// `time` [s]: not before that of the last call.
  ActualMotion at(double time);
  /// The same without going on to another span.
  ActualMotion within_span(double time);

  /// State between motors and slides at the instant that was asked for last.
  struct Slides {
    std::array<Reversal, 3> slides;
    double seen = 0;  ///< after the start of the span [s]
  };
  Slides slides() const { return {slides_, seen_}; }
  /// Goes back to an earlier instant of the span.
  void go_back(const Slides& to) {
    slides_ = to.slides;
    seen_ = to.seen;
  }

  /// How long the motors take until each has been within `window` [mm] of its set position, if these stay as
  /// they are at the start of the span, or at the end of the last one [s].
  double settling_time(double window) const;
  /// Holds the set positions there for `time` [s]; does nothing after the last span.
  void rest(double time);

  bool done() const { return set_.done(); }
  /// The span that is under way.
  const SetSpan& span() const { return set_.span(); }
  /// Goes on to the next span.
  void next_span();

 private:
  friend class DriveResponse;

  const AxisDrives& drives_;
  SetWalk set_;
  std::array<MotorMotion, 3> motors_;  ///< at the start of the span
  std::array<Reversal, 3> slides_;     ///< `seen_` after its start
  AxisSteps whole_;                    ///< to the end of the span
  AxisSteps within_;                   ///< to the instant asked for last
  double seen_ = 0;                    ///< [s]
};

}  // namespace feedscope
