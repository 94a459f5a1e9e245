#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/analysis/rotary/rotary_sample.h"
#include "core/kinematics/kinematic_chain.h"
#include "core/kinematics/series.h"
#include "core/machine/machine.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Motion of the rotary axes in a run: Toolpath::rotary_turns and Toolpath::segment_turns on the time of the
/// trajectory.
///
/// A separate turn follows a TurnLaw. During other motions the angles follow TurnCourse by the programmed
/// path length, rounded where blocks meet (Toolpath::turn_joints). Each half of the curve in a corner
/// corresponds to the path that it replaces, so velocities have small steps at the ends and in the middle of
/// such a curve.
class RotaryCourse {
 public:
  /// All rotary axes are at zero before the first turn.
  RotaryCourse(std::shared_ptr<const Trajectory> trajectory, const Machine& machine);

  const Trajectory& trajectory() const { return *trajectory_; }
  /// Whether the machine has this axis: A, B or C.
  bool has(char axis) const;
  /// `state`: of the trajectory, including its path length.
  RotarySample at(const State& state) const;
  /// Direction of the tool in the coordinates of the part, from the tip to the spindle, unit; `state` as for
  /// at().
  Vec3 tool_direction(const State& state) const;

  /// Positions of X, Y and Z of the machine with the tip on the path [mm]; `state` as for at(). Requires
  /// knows_linear().
  Vec3 slides(const State& state) const;
  /// Direction of the tool in the coordinates of the machine, unit; `state` as for at().
  Vec3 tool_on_machine(const State& state) const;

  const std::vector<RotaryAxis>& axes() const { return axes_; }
  const KinematicChain& chain() const { return chain_; }
  /// Joint that rounds the turns between segment `segment` and the next; null if none, and where the tip
  /// stops: every change of slope is passed at rest there.
  const TurnJoint* joint_behind(std::size_t segment) const;
  /// Whether the motion of X, Y and Z that follows the tip while rotary axes turn is known.
  bool knows_linear() const { return path().part.known; }

 private:
  /// A turn from the first segment with an effect on.
  struct Event {
    std::size_t segment = 0;
    double start = 0;       ///< of a separate turn [s]
    std::size_t index = 0;  ///< into Toolpath::rotary_turns or segment_turns
    bool along = false;     ///< in segment_turns
  };
  /// Progress on the programmed segment `segment`.
  struct Way {
    std::uint32_t segment = 0;
    Series share;        ///< 0 to 1, with its derivatives by time
    bool along = false;  ///< the path follows the segment: its length is not 0
  };

  const Toolpath& path() const { return *trajectory_->path().programmed(); }
  Way way_of(const State& state) const;
  Way on_lines(std::uint32_t i, const State& state) const;
  Way executed_way(const State& state, double done) const;
  /// Angles of A, B and C with their derivatives by time.
  using Angles = std::array<Series, 3>;
  Angles along(const SegmentTurn& turn, const Way& way) const;
  void add_joints(const Way& way, Angles& angles) const;
  Angles turning(const RotaryTurn& turn, double time) const;
  std::array<AxisState, 3> linear_axes(const State& state, const Angles& angles) const;
  void set_starts();

  std::shared_ptr<const Trajectory> trajectory_;
  std::vector<RotaryAxis> axes_;
  KinematicChain chain_;
  std::vector<Event> events_;       ///< in order of segments
  std::vector<std::size_t> stops_;  ///< segments at whose end the tip stops, in order
};

/// Null if the machine has no rotary axes or the run turns none.
std::shared_ptr<const RotaryCourse> rotary_course_of(std::shared_ptr<const Trajectory> trajectory,
                                                     const Machine& machine);

}  // namespace feedscope
