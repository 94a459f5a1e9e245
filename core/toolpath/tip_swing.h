#pragma once

#include "core/kinematics/kinematic_chain.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Turns of the tool about its tip, which X, Y and Z keep in place (tool centre point control, in a block
/// without motion of the tip). All axes go from rest to rest by one law of the turn's share, as slow as the
/// most limiting axis demands.
class TipSwing {
 public:
  /// All outlive it; zero and tool length of `part` are known.
  TipSwing(const Machine& machine, const KinematicChain& chain, const PartOnMachine& part)
      : machine_(machine), chain_(chain), part_(part) {}

  /// Sets RotaryTurn::law, time and axis of a turn whose ends are set; where a great circle does not lead to
  /// its end, the axes go linearly. `tip`: as programmed [mm]; `feed`: along RotaryTurn::Law::way [rad/s], 0:
  /// as fast as the axes may; `time`: given by the program instead [s], 0: none.
  void set_law(const Vec3& tip, double feed, double time, RotaryTurn& turn) const;

 private:
  const Machine& machine_;
  const KinematicChain& chain_;
  const PartOnMachine& part_;
};

}  // namespace feedscope
