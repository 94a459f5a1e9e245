#include "core/analysis/contour/path_deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <optional>

#include "core/analysis/contour/segment_tree.h"

namespace feedscope {
namespace {

constexpr double one_turn = 2 * std::numbers::pi;

/// Path length from `start` to the point of a line nearest to `position` [mm].
double nearest_on_line(const Vec3& start, const Segment& line, const Vec3& position) {
  const Vec3 along = line.end - start;
  const double squared = along.squaredNorm();
  const double u = squared > 0 ? std::clamp((position - start).dot(along) / squared, 0.0, 1.0) : 0.0;
  return u * line.length;
}

/// Angles on a helix at which its distance from a place may have its minimum. With rho and `turn` the radius
/// and angle of the place about the axis, and `aim` the angle at which the helix is as high, the squared
/// distance is, up to a constant,
///   f(a) = (aim - a)^2 h^2 - 2 r rho cos(a - turn),   h the rise per radian, r the radius.
/// Next to each angle b = turn + 2 k pi, towards the aim, there is at most one minimum, at b + y with r rho
/// sin(y) = h^2 (aim - b - y).
class HelixFoot {
 public:
  HelixFoot(const Arc& arc, const Vec3& from_center)
      : sweep_(arc.sweep),
        rise_(arc.rise.squaredNorm()),
        turn_(std::atan2(from_center.dot(arc.y), from_center.dot(arc.x))),
        aim_(from_center.dot(arc.rise) / rise_),
        pull_(arc.radius * std::hypot(from_center.dot(arc.x), from_center.dot(arc.y))) {}

  double angle() const {
    const double within = std::clamp(aim_, 0.0, sweep_);
    const double nearest = turn_ + one_turn * std::round((within - turn_) / one_turn);
    const double beside = valley(nearest);
    // If the aim is on the helix, no other valley is deeper.
    if (within == aim_ && beside >= 0 && beside <= sweep_) {
      return beside;
    }
    double best = value(0) <= value(sweep_) ? 0 : sweep_;
    for (int k = -2; k <= 2; ++k) {
      const double angle = valley(nearest + k * one_turn);
      if (angle > 0 && angle < sweep_ && value(angle) < value(best)) {
        best = angle;
      }
    }
    return best;
  }

 private:
  double value(double angle) const {
    const double off = aim_ - angle;
    return off * off * rise_ - 2 * pull_ * std::cos(angle - turn_);
  }

  /// Newton steps from y = 0; they never pass the root, because the slope of f is concave there. Without a
  /// root or convergence, any place: its value is compared.
  double valley(double base) const {
    const double gap = std::abs(aim_ - base);
    double y = 0;
    constexpr int max_steps = 60;
    for (int step = 0; step < max_steps; ++step) {
      const double bend = pull_ * std::cos(y) + rise_;
      const double left = rise_ * (gap - y) - pull_ * std::sin(y);
      if (bend <= 0 || left <= 1e-15 * rise_ * gap) {
        break;
      }
      y = std::min(y + left / bend, std::min(gap, std::numbers::pi));
    }
    return aim_ < base ? base - y : base + y;
  }

  double sweep_;
  double rise_;  ///< h^2
  double turn_;
  double aim_;
  double pull_;  ///< r rho
};

/// Path length on an arc or a helix, likewise.
double nearest_on_arc(const Arc& arc, const Vec3& position) {
  const Vec3 from_center = position - arc.center;
  if (!arc.rise.isZero(0)) {
    return HelixFoot(arc, from_center).angle() * arc.length_per_radian();
  }
  const double turn = std::atan2(from_center.dot(arc.y), from_center.dot(arc.x));
  const double angle = turn + one_turn * std::round((arc.sweep / 2 - turn) / one_turn);
  return std::clamp(angle, 0.0, arc.sweep) * arc.length_per_radian();
}

/// Squared distance from the circle of a flat arc, or from the cylinder of a helix: a lower bound for all
/// points of the arc. Needs no angle, which is the expensive part.
double squared_from_circle(const Arc& arc, const Vec3& position) {
  const Vec3 from_center = position - arc.center;
  const double x = from_center.dot(arc.x);
  const double y = from_center.dot(arc.y);
  const double across = std::sqrt(x * x + y * y) - arc.radius;
  const double beside = arc.rise.isZero(0) ? std::max(0.0, from_center.squaredNorm() - x * x - y * y) : 0;
  return across * across + beside;
}

}  // namespace

struct PathDeviation::Index {
  const SegmentTree& tree(const Toolpath& toolpath) {
    std::call_once(made, [&] { segments.emplace(toolpath); });
    return *segments;
  }

  std::once_flag made;
  std::optional<SegmentTree> segments;
};

PathDeviation::PathDeviation(const Toolpath& toolpath)
    : toolpath_(toolpath), index_(std::make_shared<Index>()) {}

PathDeviation::Foot PathDeviation::foot_on(std::size_t index, const Vec3& position) const {
  const Segment& segment = toolpath_.segments[index];
  Foot foot{index, 0, {}, 0};
  if (segment.kind == SegmentKind::arc) {
    const Arc& arc = toolpath_.arc_of(segment);
    foot.s = nearest_on_arc(arc, position);
    foot.offset = position - arc.at(foot.s).position;
  } else if (toolpath_.is_gap(segment)) {  // not part of the path
    foot.squared = std::numeric_limits<double>::infinity();
    return foot;
  } else {
    const Vec3& start = toolpath_.start_of(index);
    foot.s = nearest_on_line(start, segment, position);
    const double u = segment.length > 0 ? foot.s / segment.length : 0.0;
    foot.offset = position - (start + u * (segment.end - start));
  }
  foot.squared = foot.offset.squaredNorm();
  return foot;
}

void PathDeviation::improve(Foot& best, std::size_t segment, const Vec3& position) const {
  const Segment& other = toolpath_.segments[segment];
  if (other.kind == SegmentKind::arc &&
      squared_from_circle(toolpath_.arc_of(other), position) >= best.squared) {
    return;
  }
  const Foot foot = foot_on(segment, position);
  if (foot.squared < best.squared && std::sqrt(foot.squared) < std::sqrt(best.squared) - as_near) {
    best = foot;
  }
}

/// Enlarges the offset of a corner: a place at distance d from one leg of a corner with turn t is d / cos(t /
/// 2) from it along the bisector.
Vec3 PathDeviation::along_bisector(const Foot& foot) const {
  const bool ends = foot.s > toolpath_.segments[foot.segment].length / 2;
  const std::size_t next = foot.segment + (ends ? 1 : 0);
  if (next == 0 || next >= toolpath_.segments.size()) {
    return foot.offset;
  }
  const Vec3 in = toolpath_.tangent_at_end(next - 1);
  const Vec3 out = toolpath_.tangent_at_start(next);
  const double cosine = (in + out).norm() / 2;
  const double sine = (out - in).norm() / 2;
  constexpr double straight = 1e-4;
  constexpr double reversal = 0.05;
  if (sine < straight || cosine < reversal || in.isZero() || out.isZero()) {
    return foot.offset;
  }
  const Vec3 bisector = (out - in) / (2 * sine);
  return std::copysign(std::sqrt(foot.squared) / cosine, foot.offset.dot(bisector)) * bisector;
}

PathDeviation::Foot PathDeviation::foot_near(std::size_t segment, const Vec3& position) const {
  const Foot own = foot_on(segment, position);
  const double reach = 2 * std::sqrt(own.squared);
  Foot best = own;
  double gone = toolpath_.segments[segment].length - own.s;
  for (std::size_t i = segment + 1; i < toolpath_.segments.size() && gone <= reach; ++i) {
    improve(best, i, position);
    gone += toolpath_.segments[i].length;
  }
  gone = own.s;
  for (std::size_t i = segment; i > 0 && gone <= reach; --i) {
    improve(best, i - 1, position);
    gone += toolpath_.segments[i - 1].length;
  }
  return best;
}

PathDeviation::Foot PathDeviation::nearest(const Vec3& position, std::size_t segment,
                                           std::size_t also) const {
  Foot best = foot_on(segment, position);
  if (segment + 1 < toolpath_.segments.size()) {
    improve(best, segment + 1, position);
  }
  if (also != segment && also != segment + 1) {
    improve(best, also, position);
  }
  const auto to_beat = [&best] {
    const double nearer = std::sqrt(best.squared) - as_near;
    return nearer > 0 ? nearer * nearer : 0;
  };
  if (to_beat() > 0) {
    index_->tree(toolpath_).search(position, to_beat(), [&](std::size_t first, std::size_t count) {
      for (std::size_t i = first; i < first + count; ++i) {
        improve(best, i, position);
      }
      return to_beat();
    });
  }
  return best;
}

PathDeviation::Result PathDeviation::operator()(const Vec3& position, std::uint32_t segment) {
  if (toolpath_.segments.empty()) {
    return {};
  }
  const Foot foot = nearest(position, segment, last_);
  last_ = foot.segment;
  return from_foot(foot);
}

}  // namespace feedscope
