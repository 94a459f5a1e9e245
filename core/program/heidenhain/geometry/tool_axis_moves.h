#pragma once

#include <algorithm>
#include <cmath>

#include "core/program/cycles/tapping.h"
#include "core/program/heidenhain/cycles/drilling_cycles.h"

namespace feedscope::heidenhain {

/// Moves of the tool at one place of the plane, as steps of a plan.
class ToolAxisMoves {
 public:
  explicit ToolAxisMoves(const DrillingPlace& place)
      : plane_(place.plane),
        plan_(normal_axis(place.plane), place.path.position()[normal_axis(place.plane)]) {}

  double height() const { return plan_.level(); }
  const DrillPlan& plan() const { return plan_; }
  void rapid(double to) { plan_.rapid(to); }
  /// Cuts to a height; an infinite speed means a rapid.
  void cut(double to, double speed) {
    if (std::isinf(speed)) {
      rapid(to);
    } else if (to != height()) {
      plan_.feed(to, DrillFeed{speed});
    }
  }
  void dwell(double seconds) { plan_.dwell(seconds); }
  void tap(const Tapping& thread) { feedscope::tap(thread, plan_); }
  /// Moves in the plane by an offset.
  void shift(int direction, double by) {
    const int axis = direction % 2 == 1 ? first_axis(plane_) : second_axis(plane_);
    plan_.shift((direction <= 2 ? -by : by) * Vec3::Unit(axis));
  }

 private:
  Plane plane_;
  DrillPlan plan_;
};

/// Heights of a hole.
struct Hole {
  explicit Hole(const DrillingParameters& words)
      : top(words.surface + words.clearance),
        bottom(words.surface + words.depth),
        out(words.surface + std::max(words.second_clearance, words.clearance)) {}

  double top;
  double bottom;
  double out;
};

inline double or_else(double value, double otherwise) {
  return value > 0 ? value : otherwise;
}

inline double whole_depth_if_none(const DrillingParameters& words) {
  return words.infeed > 0 ? words.infeed : -words.depth;
}

}  // namespace feedscope::heidenhain
