#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/analysis/rotary_sample.h"
#include "core/kinematics/kinematic_chain.h"
#include "core/kinematics/series.h"
#include "core/machine/machine.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// How the rotary axes of a machine turn in a run: what Toolpath::rotary_turns and Toolpath::segment_turns
/// say, on the time of the trajectory.
///
/// A turn on its own goes by a TurnLaw. Beside other motions the angles are those of TurnCourse by the
/// programmed way, rounded where blocks meet (Toolpath::turn_joints); on the curve in a corner each half of
/// the curve is the way that it replaces, so that velocities step a little at the ends and the middle of such
/// a curve.
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

  /// Where X, Y and Z of the machine stand while the tip is where the path has it; `state` as at(). Only
  /// where knows_linear() [mm].
  Vec3 slides(const State& state) const;
  /// Of the tool in the coordinates of the machine, unit; `state` as at().
  Vec3 tool_on_machine(const State& state) const;

  const std::vector<RotaryAxis>& axes() const { return axes_; }
  const KinematicChain& chain() const { return chain_; }
  /// That rounds the turns where segment `segment` meets the next one; null for none, and where the tip
  /// stops: there every slope is passed at rest.
  const TurnJoint* joint_behind(std::size_t segment) const;
  /// It is known how X, Y and Z of the machine follow the tip where rotary axes turn.
  bool knows_linear() const { return path().part.known; }

 private:
  /// A turn from the first segment in which it shows on.
  struct Event {
    std::size_t segment = 0;
    double start = 0;       ///< of a turn of its own [s]
    std::size_t index = 0;  ///< into Toolpath::rotary_turns or segment_turns
    bool along = false;     ///< of segment_turns
  };
  /// How far the programmed segment `segment` is done.
  struct Way {
    std::uint32_t segment = 0;
    Series share;        ///< 0 to 1, with its derivatives by time
    bool along = false;  ///< the path goes along it: its length is not 0
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
  std::vector<Event> events_;       ///< by segment
  std::vector<std::size_t> stops_;  ///< segments at whose end the tip stops, in order
};

/// Null where the machine has no rotary axes or the run turns none.
std::shared_ptr<const RotaryCourse> rotary_course_of(std::shared_ptr<const Trajectory> trajectory,
                                                     const Machine& machine);

}  // namespace feedscope
