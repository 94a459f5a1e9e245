#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/analysis/rotary_sample.h"
#include "core/kinematics/kinematic_chain.h"
#include "core/machine/machine.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// How the rotary axes of a machine turn in a run: what Toolpath::rotary_turns and Toolpath::segment_turns
/// say, on the time of the trajectory.
///
/// A turn on its own goes from rest to rest at the limits of its axes (rest_to_rest_at()); axes that turn at
/// a feed arrive together, others each when it can. Beside other motions the angles are
/// those of TurnCourse by the programmed way, rounded where blocks meet (Toolpath::turn_joints); on the curve
/// in a corner each half of the curve is the way that it replaces.
class RotaryCourse {
 public:
  /// All of them stand at zero before the first turn.
  RotaryCourse(std::shared_ptr<const Trajectory> trajectory, const Machine& machine);

  const Trajectory& trajectory() const { return *trajectory_; }
  /// The machine has this axis: A, B or C.
  bool has(char axis) const;
  /// `state`: of the trajectory, with its path length.
  RotarySample at(const State& state) const;
  /// Of the tool in the coordinates of the part, from the tip to the spindle, unit; `state` as at().
  Vec3 tool_direction(const State& state) const;

  /// The tip is followed by X, Y and Z of the machine in a way that is known.
  bool knows_linear() const { return path().part.known; }
  /// Velocities of X, Y and Z of the machine, which hold the tip on its path while rotary axes turn; only if
  /// knows_linear() [mm/s]. `sample`: at() of the state.
  std::array<double, 3> linear_velocity(const State& state, const RotarySample& sample) const;

 private:
  /// A turn from the first segment in which it shows on.
  struct Event {
    std::size_t segment = 0;
    double start = 0;       ///< of a turn of its own [s]
    std::size_t index = 0;  ///< into Toolpath::rotary_turns or segment_turns
    bool along = false;     ///< of segment_turns
  };
  /// Share of the programmed segment `segment` that is behind, and how it grows by the path length.
  struct Way {
    std::uint32_t segment = 0;
    double share = 0;  ///< 0 to 1
    double slope = 0;  ///< [1/mm]
  };

  const Toolpath& path() const { return *trajectory_->path().programmed(); }
  Way way_of(const State& state) const;
  Way on_lines(std::uint32_t i, const Vec3& position) const;
  Way executed_way(const State& state, double done) const;
  RotarySample along(const SegmentTurn& turn, const Way& way, double speed) const;
  void add_joints(const Way& way, double speed, RotarySample& sample) const;
  RotarySample turning(const RotaryTurn& turn, double time) const;
  void set_starts();

  std::shared_ptr<const Trajectory> trajectory_;
  std::vector<RotaryAxis> axes_;
  KinematicChain chain_;
  std::vector<Event> events_;  ///< by segment
};

/// Null where the machine has no rotary axes or the run turns none.
std::shared_ptr<const RotaryCourse> rotary_course_of(std::shared_ptr<const Trajectory> trajectory,
                                                     const Machine& machine);

}  // namespace feedscope
