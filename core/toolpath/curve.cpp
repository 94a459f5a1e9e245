#include "core/toolpath/curve.h"

#include <cmath>
#include <numbers>

#include "core/toolpath/blend_length.h"

namespace feedscope {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// S(u) = c0 + c1 u + c2 u^2 + c3 u^3 of a blend.
struct Cubic {
  Vec3 c0;
  Vec3 c1;
  Vec3 c2;
  Vec3 c3;
};

Cubic cubic_of(const CubicBlend& blend) {
  const Vec3 m0 = blend.alpha * (blend.corner - blend.start);
  const Vec3 m1 = blend.alpha * (blend.end - blend.corner);
  const Vec3 chord = blend.end - blend.start;
  return {blend.start, m0, 3 * chord - 2 * m0 - m1, m0 + m1 - 2 * chord};
}

/// Found without looking at the arc's end: its whole circle does, or what is as far from its start as it is
/// long. Most arcs of a long program do.
bool lies_within(const Arc& arc, const Bounds& bounds) {
  const auto holds = [&](const Vec3& low, const Vec3& high) {
    return (bounds.min.array() <= low.array()).all() && (bounds.max.array() >= high.array()).all();
  };
  const Vec3 reach = arc.radius * (arc.x.array().square() + arc.y.array().square()).sqrt();
  const Vec3 climb = arc.sweep * arc.rise;
  if (holds(arc.center - reach + climb.cwiseMin(0.0), arc.center + reach + climb.cwiseMax(0.0))) {
    return true;
  }
  const Vec3 start = arc.center + arc.radius * arc.x;
  const Vec3 far = Vec3::Constant(arc.length());
  return holds(start - far, start + far);
}

}  // namespace

CurvePoint by_path_length(const CurvePoint& p) {
  const double sigma = p.d1.norm();
  const double dsigma = p.d1.dot(p.d2) / sigma;
  const double ddsigma = (p.d2.squaredNorm() + p.d1.dot(p.d3) - dsigma * dsigma) / sigma;
  const double u1 = 1 / sigma;
  const double u2 = -dsigma * u1 * u1 * u1;
  const double u3 = (-ddsigma + 3 * dsigma * dsigma * u1) * u1 * u1 * u1 * u1;
  return {p.position, p.d1 * u1, p.d2 * (u1 * u1) + p.d1 * u2,
          p.d3 * (u1 * u1 * u1) + p.d2 * (3 * u1 * u2) + p.d1 * u3};
}

double Arc::length_per_radian() const {
  return std::hypot(radius, rise.norm());
}

CurvePoint Arc::at(double s) const {
  const double rate = 1 / length_per_radian();
  const double a = s * rate;
  const Vec3 radial = radius * (std::cos(a) * x + std::sin(a) * y);
  const Vec3 tangential = radius * (std::cos(a) * y - std::sin(a) * x);
  return {center + radial + a * rise, rate * (tangential + rise), -rate * rate * radial,
          -rate * rate * rate * tangential};
}

double Arc::curvature() const {
  return radius / (radius * radius + rise.squaredNorm());
}

void Arc::extend(Bounds& bounds) const {
  if (lies_within(*this, bounds)) {
    return;
  }
  bounds.add(at(0).position);
  bounds.add(at(length()).position);
  for (int axis = 0; axis < 3; ++axis) {
    // The coordinate's slope by the angle a is radius * swing * cos(a + lead) + rise.
    const double swing = std::hypot(x[axis], y[axis]);
    if (std::abs(rise[axis]) >= radius * swing) {
      continue;
    }
    const double lead = std::atan2(x[axis], y[axis]);
    const double turn = std::acos(-rise[axis] / (radius * swing));
    for (const double root : {turn - lead, -turn - lead}) {
      const double first = root - full_turn * std::floor(root / full_turn);
      if (first > sweep) {
        continue;
      }
      // From turn to turn the same place moves by the rise alone: the first and the last time are enough.
      const double last = first + full_turn * std::floor((sweep - first) / full_turn);
      bounds.add(axis, at(first * length_per_radian()).position[axis]);
      bounds.add(axis, at(last * length_per_radian()).position[axis]);
    }
  }
}

CurvePoint CubicBlend::at(double u) const {
  const Cubic c = cubic_of(*this);
  return {c.c0 + u * (c.c1 + u * (c.c2 + u * c.c3)), c.c1 + u * (2 * c.c2 + 3 * u * c.c3),
          2 * c.c2 + 6 * u * c.c3, 6 * c.c3};
}

double CubicBlend::length() const {
  return BlendLength(*this).total();
}

double CubicBlend::length_to(double u) const {
  return BlendLength(*this).to(u);
}

double CubicBlend::parameter_at(double s) const {
  return BlendLength(*this).parameter_at(s);
}

}  // namespace feedscope
