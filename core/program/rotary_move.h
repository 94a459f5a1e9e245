#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/geometry.h"

namespace feedscope {

/// Given positions of the axes A, B and C [rad].
using RotaryTargets = std::array<std::optional<double>, 3>;

/// Position to which a program sends rotary axes; the machine determines the angles of a direction and the
/// time (on_machine()).
struct RotaryMove {
  std::uint64_t block = 0;   ///< the same for words of one block
  std::uint64_t motion = 0;  ///< motions of the program before it
  std::uint32_t line = 0;    ///< 1-based line of the block
  RotaryTargets to;          ///< from words; the other axes stay
  /// Instead of words: the tool's direction from the tip to the spindle in shown coordinates; the control
  /// finds the angles.
  std::optional<Vec3> direction;
  int side = 0;             ///< of a direction: sign of the angle next to the tool; 0: the shortest way
  double feed = 0;          ///< of all axes together [rad/s]; 0: a rapid
  double time = 0;          ///< of the block, given by the program (G93) [s]; 0: none
  bool with_rapid = false;  ///< together with the next rapid
  bool with_feed = false;   ///< together with the next feed motion
  bool at_tip = false;  ///< X, Y and Z are those of the tool's tip in the part, in this motion or meanwhile
  /// The tool's direction follows a great circle at an even rate; otherwise the axes go linearly.
  bool great_circle = false;
  double per_degree = 0;  ///< of a feed motion: length that a degree counts as in the path to which F applies
                          ///< [mm]
};

}  // namespace feedscope
