#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/kinematics/kinematic_chain.h"
#include "core/machine/machine.h"
#include "core/toolpath/rotary_notes.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Place of the part by the settings: turned from its programmed position by part_angle_x_deg about X, then
/// by _y_ about Y, then by _z_ about Z, zero where not given; its zero at part_zero_x_mm ...; tool_length_mm,
/// or the machine's.
PartOnMachine part_on_machine(const Machine& machine, const Settings& settings);

/// Positions to which the moves of a program send the rotary axes of a machine, one after the other. All axes
/// start at zero. A direction takes the angles of KinematicChain::turn_to(): those with the requested sign,
/// else the nearest. Tool vectors with feed motions take the position that a great circle leads to where the
/// tool follows one, else the nearer of two.
///
/// Where the part is turned on the machine (PartOnMachine::turn), the axes give the tool the same directions
/// relative to the part, as if the program had been posted again.
///
/// Impossible moves are reported in MachinePath::faults: a direction out of reach (the axes stay), a
/// place beyond travel (they go there).
class RotaryPositions {
 public:
  /// All arguments outlive it. `moves`: all of the program. `part` stays unturned where the program cannot
  /// follow it.
  RotaryPositions(const Machine& machine, const KinematicChain& chain, const std::vector<RotaryMove>& moves,
                  PartOnMachine& part, std::vector<Diagnostic>& faults, RotaryNotes& notes);

  /// Angles by rotary_names [rad].
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
  const PartOnMachine& part_;
  std::vector<Diagnostic>& faults_;
  RotaryNotes& notes_;
  std::array<double, 3> at_{};
  std::array<double, 3> posted_{};  ///< programmed angles, as if the part were not turned
};

}  // namespace feedscope
