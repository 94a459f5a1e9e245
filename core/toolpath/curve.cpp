#include "core/toolpath/curve.h"

#include <cmath>
#include <optional>

#include "core/toolpath/blend_length.h"

namespace feedscope {

namespace {

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

bool same(const CubicBlend& a, const CubicBlend& b) {
  return a.start == b.start && a.corner == b.corner && a.end == b.end && a.alpha == b.alpha;
}

/// Lengths along `blend`, valid until the same thread asks for another blend. Sampling a run asks for many
/// places of one blend, and preparing costs far more than each of them.
const BlendLength& lengths_along(const CubicBlend& blend) {
  struct Prepared {
    explicit Prepared(const CubicBlend& of) : blend(of), length(of) {}
    CubicBlend blend;
    BlendLength length;
  };
  thread_local std::optional<Prepared> last;
  if (!last || !same(last->blend, blend)) {
    last.emplace(blend);
  }
  return last->length;
}

}  // namespace

CurvePoint by_path_length(const CurvePoint& p) {
  const double u1 = 1 / p.d1.norm();
  const double dsigma = p.d1.dot(p.d2) * u1;
  const double ddsigma = (p.d2.squaredNorm() + p.d1.dot(p.d3) - dsigma * dsigma) * u1;
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

CurvePoint CubicBlend::at(double u) const {
  const Cubic c = cubic_of(*this);
  return {c.c0 + u * (c.c1 + u * (c.c2 + u * c.c3)), c.c1 + u * (2 * c.c2 + 3 * u * c.c3),
          2 * c.c2 + 6 * u * c.c3, 6 * c.c3};
}

double CubicBlend::length() const {
  return BlendLength(*this).total();
}

double CubicBlend::length_to(double u) const {
  return lengths_along(*this).to(u);
}

double CubicBlend::parameter_at(double s) const {
  return lengths_along(*this).parameter_at(s);
}

}  // namespace feedscope
