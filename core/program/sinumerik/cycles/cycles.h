#pragma once

#include <cstdint>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/cycles/drilling_cycle.h"
#include "core/program/sinumerik/geometry/coordinates.h"
#include "core/program/sinumerik/geometry/feeds.h"
#include "core/program/sinumerik/geometry/last_motion.h"
#include "core/program/sinumerik/geometry/path_modes.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/geometry/targets.h"
#include "core/program/sinumerik/language/subprogram_call.h"

namespace feedscope::sinumerik {

/// The control's own cycles: drilling (CYCLE81 to CYCLE89, CYCLE840), patterns of holes (HOLES1, HOLES2),
/// CYCLE800 and CYCLE832.
class Cycles : private Part {
 public:
  /// Parts used by cycles; all outlive it.
  struct Parts {
    const Feeds& feeds;
    Targets& targets;
    PathModes& path_modes;
    Splines& splines;
    Coordinates& coordinates;
    LastMotion& last;
  };
  Cycles(Context& context, const Parts& parts) : Part(context), parts_(parts) {}

  /// Returns false if `call` is not one of these cycles. `modal`: call of MCALL, nullptr for none; a pattern
  /// runs it at its holes.
  bool run(const SubprogramCall& call, const SubprogramCall* modal);

 private:
  void check_depth(int number, const SubprogramCall& call) const;
  DrillingPlace drilling_place() const;
  void drill(const DrillPlan& plan);
  void hole_pattern(const SubprogramCall& call, const SubprogramCall* modal);
  void high_speed_settings(const SubprogramCall& call);
  void swivel(const SubprogramCall& call);
  void retract(const SubprogramCall& call);
  void turn_tool(const SubprogramCall& call);

  Parts parts_;
};

}  // namespace feedscope::sinumerik
