#pragma once

#include <span>

#include "core/kinematics/series.h"
#include "core/machine/rotary_axis.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Motion of one rotary axis in a separate turn, from rest to rest (rest_to_rest_at()): axes that turn at a
/// feed arrive together, within the limits of all; otherwise each arrives as soon as it can.
class TurnLaw {
 public:
  /// `axes`: all of the machine; `axis`: one of them.
  TurnLaw(const RotaryTurn& turn, std::span<const RotaryAxis> axes, const RotaryAxis& axis);

  /// Angle [rad] with its derivatives by time, `time` from the start of the turn, clamped to it [s].
  Series at(double time) const;
  /// Magnitudes of the largest velocity, acceleration and jerk of the turn.
  RestToRestPlace largest() const;

 private:
  double from_ = 0;  ///< [rad]
  double to_ = 0;
  double share_ = 0;  ///< of the axis in the combined rotation, signed; 0: it does not turn
  double way_ = 0;    ///< rotation of all axes, or of this one [rad]
  double velocity_ = 0, acceleration_ = 0, jerk_ = 0;  ///< limits along it
};

}  // namespace feedscope
