#pragma once

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/arcs.h"
#include "core/program/sinumerik/geometry/corners.h"
#include "core/program/sinumerik/geometry/feeds.h"
#include "core/program/sinumerik/geometry/last_motion.h"
#include "core/program/sinumerik/geometry/machine_positions.h"
#include "core/program/sinumerik/geometry/path_modes.h"
#include "core/program/sinumerik/geometry/polynomials.h"
#include "core/program/sinumerik/geometry/splines.h"
#include "core/program/sinumerik/geometry/targets.h"

namespace feedscope::sinumerik {

/// Moves X, Y and Z of a block along the path: rapids, lines, threads; other parts run arcs, splines,
/// polynomials and machine positions.
class Motions : private Part {
 public:
  /// Receivers of the motions; all outlive it.
  struct Parts {
    const Feeds& feeds;
    Targets& targets;
    PathModes& path_modes;
    Splines& splines;
    Polynomials& polynomials;
    Arcs& arcs;
    Corners& corners;
    MachinePositions& machine_positions;
    LastMotion& last;
  };
  Motions(Context& context, const Parts& parts) : Part(context), parts_(parts) {}

  /// True if the block has words of a motion along the path.
  bool has_words() const;
  /// Returns false if the block does not move along the path.
  bool run();

 private:
  void move(Action action);
  void thread(const Vec3& target);
  void check_unused(bool arc) const;

  Parts parts_;
};

}  // namespace feedscope::sinumerik
