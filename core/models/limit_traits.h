#pragma once

#include <string_view>
#include <vector>

#include "core/limits/formula.h"

namespace feedscope {

/// Where the limits of a model differ from the static ones that most share, so that a limit can be explained
/// with the formula and the source that the model uses.
struct LimitTraits {
  /// On corner blends ramps have what the radial shares leave of acceleration and jerk; else all of it.
  bool ramps_share_corners = true;
  /// Limits of an arc hold at the place where its steady feed is reached (Tapie 2007), else all along it.
  bool at_steady_place = false;
  /// An axis limit holds along and across the path together, on ramps too.
  bool along_and_across = false;

  /// Corners are passed as they are programmed, so that the velocity of an axis jumps there.
  bool jumps_in_corners = false;
  /// The control limits velocity and acceleration along the path, with limits of its own for Z: settings of
  /// model `klipper`.
  bool along_path = false;
  /// Blends of corners and joints of blocks take a part of the acceleration of the axes: model `linuxcnc`.
  bool joints_take_acceleration = false;
  /// Key of the setting that says within how many blocks the control, which limits no jerk, must be able to
  /// stop; empty: look-ahead as most share it.
  std::string_view stops_within = {};

  struct Source {
    FormulaId formula = FormulaId::none;
    std::string_view text;  ///< paper and equation
  };
  std::vector<Source> sources = {};  ///< those that are not the shared ones
};

}  // namespace feedscope
