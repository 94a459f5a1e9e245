#include "core/analysis/path_deviation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace feedscope {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Path length on a line from `start` at which it comes nearest to `position` [mm].
double nearest_on_line(const Vec3& start, const Segment& line, const Vec3& position) {
  const Vec3 along = line.end - start;
  const double squared = along.squaredNorm();
  const double u = squared > 0 ? std::clamp((position - start).dot(along) / squared, 0.0, 1.0) : 0.0;
  return u * line.length;
}

/// The same on an arc. A flat arc has a closed form; on a helix it is the start for Newton steps on the slope
/// of the squared distance.
double nearest_on_arc(const Arc& arc, const Vec3& position) {
  const Vec3 from_center = position - arc.center;
  const double turn = std::atan2(from_center.dot(arc.y), from_center.dot(arc.x));
  const double rise = arc.rise.squaredNorm();
  const double aim = rise > 0 ? std::clamp(from_center.dot(arc.rise) / rise, 0.0, arc.sweep) : arc.sweep / 2;
  const double angle = std::clamp(turn + full_turn * std::round((aim - turn) / full_turn), 0.0, arc.sweep);
  const double rate = arc.length_per_radian();
  double s = angle * rate;
  constexpr int newton_steps = 4;
  for (int step = 0; rise > 0 && step < newton_steps; ++step) {
    const CurvePoint at = arc.at(s);
    const Vec3 offset = at.position - position;
    const double bend = at.d1.squaredNorm() + offset.dot(at.d2);
    if (bend <= 0) {
      break;
    }
    s = std::clamp(s - offset.dot(at.d1) / bend, 0.0, arc.sweep * rate);
  }
  return s;
}

}  // namespace

PathDeviation::Foot PathDeviation::foot_on(std::size_t index, const Vec3& position) const {
  const Segment& segment = toolpath_.segments[index];
  Foot foot{index, 0, {}, 0};
  if (segment.kind == SegmentKind::arc) {
    const Arc& arc = toolpath_.arc_of(segment);
    foot.s = nearest_on_arc(arc, position);
    foot.offset = position - arc.at(foot.s).position;
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
  const Foot foot = foot_on(segment, position);
  if (foot.squared < best.squared) {
    best = foot;
  }
}

void PathDeviation::search(Foot& best, const Foot& from, double reach, const Vec3& position) const {
  double gone = toolpath_.segments[from.segment].length - from.s;
  for (std::size_t i = from.segment + 1; i < toolpath_.segments.size() && gone <= reach; ++i) {
    improve(best, i, position);
    gone += toolpath_.segments[i].length;
  }
  gone = from.s;
  for (std::size_t i = from.segment; i > 0 && gone <= reach; --i) {
    improve(best, i - 1, position);
    gone += toolpath_.segments[i - 1].length;
  }
}

/// A place at distance d from one leg of a corner with turn t is d / cos(t / 2) from it along the bisector.
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

PathDeviation::Foot PathDeviation::follow(const Foot& from, const Vec3& position, double advance,
                                          std::uint32_t segment) const {
  Foot best = foot_on(from.segment, position);
  for (const std::size_t near : {std::size_t{segment}, std::size_t{segment} + 1}) {
    if (near < toolpath_.segments.size()) {
      improve(best, near, position);
    }
  }
  // The feet of two places are apart by at most the places' own distance and the two distances from the path.
  search(best, Foot(best), 2 * (advance + std::sqrt(from.squared)), position);
  return best;
}

PathDeviation::Result PathDeviation::operator()(const Vec3& position, double advance, std::uint32_t segment) {
  if (toolpath_.segments.empty()) {
    return {};
  }
  last_ = follow(last_, position, advance, segment);
  return {last_.offset, along_bisector(last_)};
}

}  // namespace feedscope
