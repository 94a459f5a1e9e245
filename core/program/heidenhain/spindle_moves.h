#pragma once

#include <algorithm>
#include <cmath>

#include "core/program/heidenhain/drilling_cycles.h"

namespace feedscope {

/// Moves along the tool axis, at one place of the plane.
class Spindle {
 public:
  explicit Spindle(const DrillingPlace& place)
      : path_(place.path), axis_(normal_axis(place.plane)), plane_(place.plane) {
    path_.set_feed_mode(FeedMode::per_minute);
  }

  double height() const { return path_.position()[axis_]; }
  void rapid(double to) {
    if (to != height()) {
      path_.rapid(at(to));
    }
  }
  /// An infinite speed is rapid traverse.
  void cut(double to, double speed) {
    if (std::isinf(speed)) {
      rapid(to);
    } else if (to != height()) {
      path_.set_feed(speed);
      path_.line(at(to));
    }
  }
  void dwell(double seconds) {
    if (seconds > 0) {
      path_.dwell(seconds);
    }
  }
  /// In the plane, by an offset.
  void shift(int direction, double by) {
    Vec3 target = path_.position();
    const int axis = direction % 2 == 1 ? first_axis(plane_) : second_axis(plane_);
    target[axis] += direction <= 2 ? -by : by;
    path_.rapid(target);
  }

 private:
  Vec3 at(double height) const {
    Vec3 target = path_.position();
    target[axis_] = height;
    return target;
  }

  PathWriter& path_;
  int axis_;
  Plane plane_;
};

/// Heights of a hole.
struct Hole {
  explicit Hole(const Drilling& words)
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

inline double whole_depth_if_none(const Drilling& words) {
  return words.infeed > 0 ? words.infeed : -words.depth;
}

}  // namespace feedscope
