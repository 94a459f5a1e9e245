#include "core/toolpath/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace feedscope {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Positive nodes and their weights of the 12-point Gauss-Legendre rule on [-1, 1].
constexpr std::array<std::array<double, 2>, 6> gauss_rule{{{0.12523340851146891, 0.24914704581340277},
                                                           {0.36783149899818018, 0.23349253653835481},
                                                           {0.58731795428661748, 0.20316742672306592},
                                                           {0.76990267419430469, 0.16007832854334622},
                                                           {0.90411725637047480, 0.10693932599531843},
                                                           {0.98156063424671924, 0.04717533638651183}}};

/// S(u) = c0 + c1 u + c2 u^2 + c3 u^3 of a blend.
struct Cubic {
  Vec3 c0;
  Vec3 c1;
  Vec3 c2;
  Vec3 c3;

  double speed(double u) const { return (c1 + u * (2 * c2 + 3 * u * c3)).norm(); }
};

Cubic cubic_of(const CubicBlend& blend) {
  const Vec3 m0 = blend.alpha * (blend.corner - blend.start);
  const Vec3 m1 = blend.alpha * (blend.end - blend.corner);
  const Vec3 chord = blend.end - blend.start;
  return {blend.start, m0, 3 * chord - 2 * m0 - m1, m0 + m1 - 2 * chord};
}

double gauss(const Cubic& cubic, double from, double to) {
  const double middle = (from + to) / 2;
  const double half = (to - from) / 2;
  double sum = 0;
  for (const auto& [node, weight] : gauss_rule) {
    sum += weight * (cubic.speed(middle - half * node) + cubic.speed(middle + half * node));
  }
  return sum * half;
}

/// Halves the interval until both halves together agree with the whole. The speed of a sharply turning
/// blend nearly vanishes at one place, where one rule over the whole interval is poor.
double refine(const Cubic& cubic, double from, double to, double whole, double tolerance, int depth) {
  const double middle = (from + to) / 2;
  const double first = gauss(cubic, from, middle);
  const double second = gauss(cubic, middle, to);
  if (std::abs(first + second - whole) <= tolerance || depth == 0) {
    return first + second;
  }
  return refine(cubic, from, middle, first, tolerance, depth - 1) +
         refine(cubic, middle, to, second, tolerance, depth - 1);
}

double arc_length(const Cubic& cubic, double from, double to) {
  constexpr double relative_tolerance = 1e-12;
  constexpr int deepest = 48;
  const double scale = cubic.c1.norm() + cubic.c2.norm() + cubic.c3.norm();
  return refine(cubic, from, to, gauss(cubic, from, to), relative_tolerance * scale, deepest);
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
  return length_to(1);
}

double CubicBlend::length_to(double u) const {
  return arc_length(cubic_of(*this), 0, u);
}

double CubicBlend::parameter_at(double s) const {
  const Cubic cubic = cubic_of(*this);
  const double total = arc_length(cubic, 0, 1);
  if (s <= 0 || total <= 0) {
    return 0;
  }
  if (s >= total) {
    return 1;
  }
  // Newton steps, kept inside a bracket because the slope may vanish on the way.
  double low = 0;
  double high = 1;
  double u = s / total;
  double reached = arc_length(cubic, 0, u);
  const double tolerance = 1e-14 * total;
  for (int step = 0; step < 100 && std::abs(reached - s) > tolerance; ++step) {
    (reached > s ? high : low) = u;
    const double slope = cubic.speed(u);
    double next = slope > 0 ? u - (reached - s) / slope : low;
    if (next <= low || next >= high) {
      next = (low + high) / 2;
    }
    if (next == u) {
      break;
    }
    reached += arc_length(cubic, u, next);
    u = next;
  }
  return u;
}

}  // namespace feedscope
