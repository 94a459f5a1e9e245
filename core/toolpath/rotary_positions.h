#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/kinematics/kinematic_chain.h"
#include "core/machine/machine.h"
#include "core/toolpath/rotary_notes.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// By the settings: turned against how the program was made for by part_angle_x_deg about X, then by _y_
/// about Y, then by _z_ about Z, what of them is not given by zero; part_zero_x_mm ..., tool_length_mm or
/// that of the machine.
PartOnMachine part_on_machine(const Machine& machine, const Settings& settings);

/// Where the moves of a program send the rotary axes of a machine, one after the other. All stand at zero
/// before the first. A direction takes the angles that KinematicChain::turn_to() gives, those with the sign
/// that is asked for, else the nearest; tool vectors beside feed motions the position that a great circle
/// leads to where the tool goes along one, else the nearer of two.
///
/// Where the part is turned on the machine (Toolpath::part), the axes give the tool the directions in
/// the part that it would have without, as if the program had been posted again.
///
/// What cannot be is in Toolpath::machine_faults: a direction out of reach (the axes stay), a place beyond
/// travel (they go there).
class RotaryPositions {
 public:
  /// All outlive it; `path`: whose faults it writes. `moves`: all of the program.
  RotaryPositions(const Machine& machine, const KinematicChain& chain, const std::vector<RotaryMove>& moves,
                  Toolpath& path, RotaryNotes& notes);

  /// By rotary_names [rad].
  const std::array<double, 3>& at() const { return at_; }
  void follow(const RotaryMove& move);

 private:
  std::array<double, 3> asked_by(const RotaryMove& move);
  std::array<double, 3> angles_for(const RotaryMove& move, const Vec3& direction);
  bool leads_to(const std::vector<double>& angles) const;
  std::array<double, 3> nearest(const Vec3& direction, std::array<double, 3> from) const;
  void fault(std::uint32_t line, Severity severity, MessageCode code, Message what, Message hint);

  const Machine& machine_;
  const KinematicChain& chain_;
  std::vector<const RotaryAxis*> axes_;  ///< in the order of the chain
  Toolpath& path_;
  RotaryNotes& notes_;
  std::array<double, 3> at_{};
  std::array<double, 3> posted_{};  ///< where the program has sent them, were the part not turned
};

}  // namespace feedscope
