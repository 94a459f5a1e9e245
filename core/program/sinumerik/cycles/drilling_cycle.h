#pragma once

#include <functional>
#include <optional>

#include "core/program/cycles/drill_plan.h"
#include "core/program/path/plane.h"
#include "core/program/sinumerik/language/arguments.h"

namespace feedscope::sinumerik {

/// Modal state when a drilling cycle is called.
struct DrillingPlace {
  Plane plane = Plane::xy;
  Vec3 position = Vec3::Zero();  ///< of the tool [mm]
  double mm = 1;                 ///< per programmed unit of length [mm]
  double feed = 0;               ///< as PathWriter::feed()
  FeedMode mode = FeedMode::per_minute;
  double spindle_speed = 0;               ///< [1/s]
  std::function<double(double)> feed_of;  ///< PathWriter::set_feed() of a number in the sense of F
};

/// One hole of CYCLE81 to CYCLE89 and CYCLE840, from above it; parameters in the order of the Programming
/// Manual NC, "programming cycles externally". None for other numbers.
std::optional<DrillPlan> drill_plan(int number, const Arguments& arguments, const DrillingPlace& place);

}  // namespace feedscope::sinumerik
