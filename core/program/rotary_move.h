#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/geometry.h"

namespace feedscope {

/// Positions of the axes A, B and C, as far as they are given [rad].
using RotaryTargets = std::array<std::optional<double>, 3>;

/// Where a program sends rotary axes: what the angles of a direction are and what time it takes, the machine
/// says (on_machine()).
struct RotaryMove {
  std::uint64_t block = 0;   ///< the same for words of one block
  std::uint64_t motion = 0;  ///< motions of the program before it
  std::uint32_t line = 0;    ///< 1-based line of the block
  RotaryTargets to;          ///< of words; the other axes stay
  /// Instead of words: the tool's direction, from the tip to the spindle, in the coordinates that are shown;
  /// the control finds the angles.
  std::optional<Vec3> direction;
  int side = 0;             ///< sign of the angle next to the tool, of a direction; 0: the shortest way
  double feed = 0;          ///< of all the axes together [rad/s]; 0: a rapid
  double time = 0;          ///< that the program gives the block (G93) [s]; 0: none
  bool with_rapid = false;  ///< at once with the rapid that follows
  bool with_feed = false;   ///< at once with the feed motion that follows
  bool at_tip = false;  ///< X, Y and Z are those of the tool's tip in the part, of this motion or meanwhile
  /// Along it the tool's direction goes along a great circle at an even rate, else the axes go linearly.
  bool great_circle = false;
  double per_degree = 0;  ///< of a feed motion: part of the way along which F holds that a degree is [mm]
};

}  // namespace feedscope
