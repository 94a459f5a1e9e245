#pragma once

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/compensation.h"
#include "core/program/sinumerik/geometry/coordinates.h"
#include "core/program/sinumerik/geometry/corners.h"
#include "core/program/sinumerik/geometry/feeds.h"
#include "core/program/sinumerik/geometry/path_modes.h"
#include "core/program/sinumerik/geometry/positioning_axes.h"
#include "core/program/sinumerik/geometry/targets.h"

namespace feedscope::sinumerik {

/// Stores the modal state of all parts, and restores it after a subprogram with PROC ... SAVE.
class KeptModes : private Part {
 public:
  /// Parts whose modes are stored; all outlive it.
  struct Parts {
    Feeds& feeds;
    Targets& targets;
    PathModes& path_modes;
    Compensation& compensation;
    Corners& corners;
    Coordinates& coordinates;
    PositioningAxes& positioning_axes;
  };
  KeptModes(Context& context, const Parts& parts) : Part(context), parts_(parts) {}

  struct Kept {
    ModalState modal;
    bool surface_speed = false;
    Targets::Modes targets;
    PathWords path_words;
    Compensation::Modes compensation;
    Corners::Modes corners;
    Coordinates::Modes coordinates;
    PositioningAxes::AxisFeeds axis_feeds{};
  };
  Kept keep() const;
  /// Also restores the path's frame.
  void restore(const Kept& kept);

 private:
  Parts parts_;
};

}  // namespace feedscope::sinumerik
