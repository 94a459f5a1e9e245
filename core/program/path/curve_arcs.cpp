#include "core/program/path/curve_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace feedscope {

namespace {

/// Evenly spaced checks inside a part; a curve of degree 7 cannot meet its biarc at all of them by chance.
constexpr int looks = 7;
/// Largest share of the way over all checked places that may lie between two of them. Where a curve speeds
/// up, as with very different weights, a bend could otherwise be missed; 0.33 is where its slope vanishes
/// like that of t^3.
constexpr double max_share = 0.4;
/// Share of the tolerance that a biarc may use at the checked places; the rest is for the places between.
/// Each half of it has an error like sin^2 over four checks, of which the nearest is cos^2(pi / 8) as high as
/// the maximum.
constexpr double looked_share = 0.85;
/// Above this radius an arc is a line [mm].
constexpr double flat_radius = 1e7;
/// Least chord of an arc, well above the distance of equal points [mm].
constexpr double min_chord = 10 * same_point;

struct End {
  double parameter = 0;
  Vec3 point;
  Vec3 before;  ///< unit direction of motion on the side of lower parameters
  Vec3 behind;  ///< the same on the other side: different at a cusp
};

Vec3 unit(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

double distance_to_line(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 chord = to - from;
  const double length = chord.squaredNorm();
  const double share = length > 0 ? std::clamp(chord.dot(point - from) / length, 0.0, 1.0) : 0;
  return (point - from - share * chord).norm();
}

/// One half of a biarc.
struct HalfArc {
  Vec3 from;
  Vec3 to;
  Vec3 center;
  Vec3 axis;
  double radius = 0;  ///< 0: a line
  double sweep = 0;

  double length() const { return radius > 0 ? radius * sweep : (to - from).norm(); }
  double distance(const Vec3& point) const;
  CurvePiece piece() const { return {to, radius > 0, center, axis, length()}; }
};

double HalfArc::distance(const Vec3& point) const {
  if (radius == 0) {
    return distance_to_line(point, from, to);
  }
  const Vec3 x = (from - center) / radius;
  const Vec3 q = point - center;
  const double u = q.dot(x);
  const double v = q.dot(axis.cross(x));
  const double angle = std::atan2(v, u);
  if (angle >= 0 && angle <= sweep) {
    return std::hypot(std::hypot(u, v) - radius, q.dot(axis));
  }
  return std::min((point - from).norm(), (point - to).norm());
}

/// From `from`, which it leaves along unit `tangent`, to `to`; none if it would turn more than a quarter.
///     radius = |w|^2 / (2 |n|), w = to - from, n: the part of w across the tangent
std::optional<HalfArc> half_arc(const Vec3& from, const Vec3& tangent, const Vec3& to) {
  const Vec3 w = to - from;
  const double along = w.dot(tangent);
  const Vec3 n = w - along * tangent;
  const double across = n.norm();
  if (!(along > across) || !(w.norm() > min_chord)) {
    return std::nullopt;
  }
  HalfArc arc{from, to, Vec3::Zero(), Vec3::UnitZ()};
  if (w.squaredNorm() < 2 * across * flat_radius) {
    arc.radius = w.squaredNorm() / (2 * across);
    arc.center = from + arc.radius / across * n;
    arc.axis = tangent.cross(n).normalized();
    arc.sweep = 2 * std::atan2(across, along);
  }
  return arc;
}

class Fitter {
 public:
  Fitter(const ParametricCurve& curve, double from, double to) : curve_(curve), range_(to - from) {}

  CurvePieces fit(double from, double to) {
    const End first = end_at(from);
    const End last = end_at(to);
    divide(first, last, 0);
    pieces_.end_direction = last.before;
    return std::move(pieces_);
  }

 private:
  using Looks = std::array<Vec3, looks>;

  Vec3 direction_from(double parameter, double step) const;
  End end_at(double parameter) const;
  void divide(const End& from, const End& to, int halvings);
  bool take_biarc(const End& from, const End& to, const Looks& between);
  void take(const CurvePiece& piece);

  const ParametricCurve& curve_;
  double range_;
  CurvePieces pieces_;
};

/// Direction of motion where the slope vanishes, on the side of `step`: extrapolated from two places near it,
/// with an error of second order.
Vec3 Fitter::direction_from(double parameter, double step) const {
  const Vec3 near = unit(curve_(parameter + step).slope);
  const Vec3 far = unit(curve_(parameter + 2 * step).slope);
  return unit(2 * near - far);
}

End Fitter::end_at(double parameter) const {
  constexpr double no_way = 1e-8;  // [mm] over the whole range at this slope
  constexpr double beside = 1e-3;
  const CurvePlace place = curve_(parameter);
  if (place.slope.norm() * std::abs(range_) > no_way) {
    const Vec3 direction = unit(place.slope);
    return {parameter, place.point, direction, direction};
  }
  const double step = beside * range_;
  return {parameter, place.point, direction_from(parameter, -step), direction_from(parameter, step)};
}

void Fitter::divide(const End& from, const End& to, int halvings) {
  const double width = to.parameter - from.parameter;
  Looks between;
  bool is_speck = (to.point - from.point).norm() <= curve_tolerance;
  double way = 0;
  double longest = 0;
  const auto step = [&](const Vec3& last, const Vec3& next) {
    const double length = (next - last).norm();
    way += length;
    longest = std::max(longest, length);
  };
  for (int i = 0; i < looks; ++i) {
    Vec3& point = between[static_cast<std::size_t>(i)];
    point = curve_(from.parameter + width * (i + 1) / (looks + 1)).point;
    is_speck = is_speck && (point - from.point).norm() <= curve_tolerance;
    step(i == 0 ? from.point : between[static_cast<std::size_t>(i - 1)], point);
  }
  step(between.back(), to.point);
  if (longest <= max_share * way && take_biarc(from, to, between)) {
    return;
  }
  if (is_speck || halvings >= max_curve_halvings) {
    take({.end = to.point, .length = (to.point - from.point).norm()});
    return;
  }
  const End middle = end_at(from.parameter + width / 2);
  divide(from, middle, halvings + 1);
  divide(middle, to, halvings + 1);
}

bool Fitter::take_biarc(const End& from, const End& to, const Looks& between) {
  const Vec3 v = to.point - from.point;
  const double along = v.dot(from.behind + to.before);
  const double opening = 2 * (1 - from.behind.dot(to.before));
  const double root = std::sqrt(along * along + opening * v.squaredNorm());
  if (!(along + root > 0)) {
    return false;
  }
  const double d = v.squaredNorm() / (along + root);
  const Vec3 joint = (from.point + to.point + d * (from.behind - to.before)) / 2;
  const std::optional<HalfArc> first = half_arc(from.point, from.behind, joint);
  std::optional<HalfArc> second = half_arc(to.point, -to.before, joint);
  if (!first || !second) {
    return false;
  }
  std::swap(second->from, second->to);
  second->axis = -second->axis;
  for (const Vec3& point : between) {
    if (!(std::min(first->distance(point), second->distance(point)) <= looked_share * curve_tolerance)) {
      return false;
    }
  }
  if (first->radius == 0 && second->radius == 0) {
    take({.end = to.point, .length = v.norm()});
  } else {
    take(first->piece());
    take(second->piece());
  }
  return true;
}

void Fitter::take(const CurvePiece& piece) {
  pieces_.pieces.push_back(piece);
  pieces_.length += piece.length;
}

}  // namespace

CurvePieces arcs_of_curve(const ParametricCurve& curve, double from, double to) {
  return Fitter(curve, from, to).fit(from, to);
}

}  // namespace feedscope
