#pragma once

#include <string_view>
#include <vector>

#include "core/limits/formula.h"

namespace feedscope {

/// Differences of a model's limits from the shared static ones, so that a limit can be explained with the
/// formula and the source of the model.
struct LimitTraits {
  /// On corner blends ramps use the acceleration and jerk left by the radial shares; else all of it.
  bool ramps_share_corners = true;
  /// Limits of an arc apply at the place where its steady feed is reached (Tapie 2007), else all along it.
  bool at_steady_place = false;
  /// An axis limit applies to the sum along and across the path, on ramps too.
  bool along_and_across = false;

  /// Corners are passed as programmed, so that the velocity of an axis jumps there.
  bool jumps_in_corners = false;
  /// The control limits velocity and acceleration along the path, with separate limits for Z: settings of
  /// model `klipper`.
  bool along_path = false;
  /// Corner blends and joints of blocks use a part of the acceleration of the axes: model `linuxcnc`.
  bool joints_take_acceleration = false;
  /// Key of the setting for the number of blocks within which the control, which does not limit jerk, must be
  /// able to stop; empty: shared look-ahead.
  std::string_view stops_within = {};

  struct Source {
    FormulaId formula = FormulaId::none;
    std::string_view text;  ///< paper and equation
  };
  std::vector<Source> sources = {};  ///< sources that differ from the shared ones
};

}  // namespace feedscope
