#include "core/program/path/path_extents.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace feedscope {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

bool holds(const Bounds& bounds, const Vec3& low, const Vec3& high) {
  return (bounds.min.array() <= low.array()).all() && (bounds.max.array() >= high.array()).all();
}

/// Quick test without the arc's end: its whole circle lies within or, up to half a turn, the circle about its
/// ends. True for most arcs of a long program.
bool lies_within(const Bounds& bounds, const Vec3& start, const Vec3& end, const ArcWords& words,
                 const Vec3& from, const Vec3& to) {
  const Vec3 climb = words.axis.dot(end - start) * words.axis;
  const Vec3 reach = from.norm() * (1 - words.axis.array().square()).max(0.0).sqrt().matrix();
  const Vec3 center = start - from;
  if (holds(bounds, center - reach + climb.cwiseMin(0.0), center + reach + climb.cwiseMax(0.0))) {
    return true;
  }
  const bool up_to_half = words.turns == 0 && words.axis.dot(from.cross(to)) >= 0;
  if (!up_to_half) {
    return false;
  }
  const Vec3 middle = (start + end) / 2;
  const Vec3 far = Vec3::Constant((end - start).norm());
  return holds(bounds, middle - far, middle + far);
}

}  // namespace

void add_arc(Bounds& bounds, const Vec3& start, const Vec3& end, const ArcWords& words) {
  const Vec3& axis = words.axis;
  const auto in_plane = [&](const Vec3& v) -> Vec3 { return v - axis.dot(v) * axis; };
  const Vec3 from = in_plane(start - words.center);
  const Vec3 to = in_plane(end - words.center);
  if (lies_within(bounds, start, end, words, from, to)) {
    return;
  }
  bounds.add(start);
  bounds.add(end);
  double sweep = 0;
  if ((to - from).norm() > same_point) {
    sweep = std::atan2(axis.dot(from.cross(to)), from.dot(to));
    sweep += sweep < 0 ? full_turn : 0;
  }
  sweep += full_turn * words.turns;
  const Vec3 across = axis.cross(from);
  const Vec3 rise = axis.dot(end - start) / sweep * axis;  // per radian
  // A coordinate at the angle a is center + from cos(a) + across sin(a) + rise a.
  const auto coordinate = [&](int i, double a) {
    return start[i] - from[i] + from[i] * std::cos(a) + across[i] * std::sin(a) + rise[i] * a;
  };
  for (int i = 0; i < 3; ++i) {
    // Its slope is swing cos(a + lead) + rise.
    const double swing = std::hypot(from[i], across[i]);
    if (std::abs(rise[i]) >= swing) {
      continue;
    }
    const double lead = std::atan2(from[i], across[i]);
    const double turn = std::acos(-rise[i] / swing);
    for (const double root : {turn - lead, -turn - lead}) {
      const double first = root - full_turn * std::floor(root / full_turn);
      if (first > sweep) {
        continue;
      }
      // From turn to turn the same place moves by the rise alone: the first and the last turn are enough.
      bounds.add(i, coordinate(i, first));
      bounds.add(i, coordinate(i, first + full_turn * std::floor((sweep - first) / full_turn)));
    }
  }
}

void PathExtents::add(const MotionBlock& block, const ArcWords& arc, const std::array<bool, 3>& axes) {
  if (block.motion == Motion::dwell) {
    return;
  }
  const bool rapid = block.motion == Motion::rapid;
  Bounds& kind = rapid ? program_.rapid_bounds : program_.cutting_bounds;
  for (int axis = 0; axis < 3; ++axis) {
    bool& known = known_[static_cast<std::size_t>(axis)];
    known = known || !rapid;
    if (known) {
      program_.bounds.add(axis, position_[axis]);
      kind.add(axis, position_[axis]);
    }
    known = known || axes[static_cast<std::size_t>(axis)];
    if (known) {
      program_.bounds.add(axis, block.target[axis]);
      kind.add(axis, block.target[axis]);
    }
  }
  if (block.motion == Motion::arc) {
    // Everything within the cutting bounds is within both.
    add_arc(program_.cutting_bounds, position_, block.target, arc);
    program_.bounds.add(program_.cutting_bounds.min);
    program_.bounds.add(program_.cutting_bounds.max);
  }
  position_ = block.target;
}

void PathExtents::go_on_at(const Vec3& to, const std::array<bool, 3>& axes) {
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    known_[axis] = known_[axis] || axes[axis];
  }
  position_ = to;
}

}  // namespace feedscope
