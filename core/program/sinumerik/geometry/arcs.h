#pragma once

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/last_motion.h"
#include "core/program/sinumerik/geometry/targets.h"

namespace feedscope::sinumerik {

/// Arcs: G2 and G3 by a centre, radius, opening angle or about the pole, CIP through a point, CT tangential
/// to the previous motion. An impossible one is reported and becomes a line.
class Arcs : private Part {
 public:
  /// All outlive it.
  Arcs(Context& context, const Targets& targets, LastMotion& last)
      : Part(context), targets_(targets), last_(last) {}

  static bool makes(Action action) {
    return action == Action::arc_cw || action == Action::arc_ccw || action == Action::arc_through ||
           action == Action::arc_tangent;
  }
  /// Moves from the position to `target`, programmed coordinates [mm], by the motion word in force.
  void move(const Vec3& target);

 private:
  void arc(const Vec3& target);
  double extra_turns() const;
  void plain_arc(const Vec3& target, ArcRequest& request);
  void angle_arc(const Vec3& target, ArcRequest& request);
  void arc_through(const Vec3& target);
  void tangent_arc(const Vec3& target);
  void straight(const Vec3& target);
  void by_center(const ArcRequest& request);
  void by_radius(const ArcRequest& request);

  const Targets& targets_;
  LastMotion& last_;
};

}  // namespace feedscope::sinumerik
