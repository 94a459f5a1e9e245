#include "core/blend/fitted_course.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// Nodes on [0, 1] and weights of the 5-point Gauss-Legendre rule: spans turn little, their speed by the
/// parameter is 1 within a thousandth, and the rule has no error for that.
constexpr std::array<std::array<double, 2>, 5> gauss_rule{{{0.046910077030668004, 0.11846344252809454},
                                                           {0.23076534494715845, 0.23931433524968324},
                                                           {0.5, 0.28444444444444444},
                                                           {0.76923465505284155, 0.23931433524968324},
                                                           {0.953089922969332, 0.11846344252809454}}};

constexpr int max_steps = 30;
constexpr double rounding = 1e-15;
/// The error of a Newton step is its square times the change of the speed by the parameter.
constexpr double square_is_rounding = 1e-7;

}  // namespace

CourseSpan::CourseSpan(const CourseKnot& from, const CourseKnot& to, double length)
    : length_(length), start_(from.position) {
  const Vec3 chord = to.position - from.position;
  const Vec3 m0 = length * from.tangent;
  const Vec3 m1 = length * to.tangent;
  const Vec3 k0 = length * length / 2 * from.curvature;
  const Vec3 k1 = length * length / 2 * to.curvature;
  coefficients_ = {m0, k0, 10 * chord - 6 * m0 - 4 * m1 - 3 * k0 + k1,
                   -15 * chord + 8 * m0 + 7 * m1 + 3 * k0 - 2 * k1, 6 * chord - 3 * (m0 + m1) - k0 + k1};
  whole_ = covered(1);
}

CourseSpan::CourseSpan(const CourseKnot& from, const CourseKnot& to) : CourseSpan(from, to, to.s - from.s) {}

double CourseSpan::covered(double x) const {
  const auto& c = coefficients_;
  double sum = 0;
  for (const auto& [node, weight] : gauss_rule) {
    const double at = node * x;
    const Vec3 slope = c[0] + at * (2 * c[1] + at * (3 * c[2] + at * (4 * c[3] + at * 5 * c[4])));
    sum += weight * slope.norm();
  }
  return x * sum;
}

CurvePoint CourseSpan::by_parameter(double x) const {
  const auto& c = coefficients_;
  return {start_ + x * (c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])))),
          c[0] + x * (2 * c[1] + x * (3 * c[2] + x * (4 * c[3] + x * 5 * c[4]))),
          2 * c[1] + x * (6 * c[2] + x * (12 * c[3] + x * 20 * c[4])),
          6 * c[2] + x * (24 * c[3] + x * 60 * c[4])};
}

/// The parameter at path length `s`.
double CourseSpan::share_at(double s) const {
  const double share = std::clamp(s / length_, 0.0, 1.0);
  const double target = share * whole_;
  double x = share;
  for (int i = 0; i < max_steps && x > 0 && x < 1; ++i) {
    const double step = (target - covered(x)) / by_parameter(x).d1.norm();
    x = std::clamp(x + step, 0.0, 1.0);
    if (std::abs(step) <= square_is_rounding) {
      break;
    }
  }
  return x;
}

CurvePoint CourseSpan::at(double s) const {
  return by_path_length(by_parameter(share_at(s)));
}

std::array<Vec3, 4> CourseSpan::derivatives(double s) const {
  const double x = share_at(s);
  const CurvePoint at = by_parameter(x);
  return {at.d1, at.d2, at.d3, 24 * coefficients_[3] + 120 * x * coefficients_[4]};
}

double CourseSpan::distance(const Vec3& point, double& s) const {
  double x = s / length_;
  for (int i = 0; i < 3; ++i) {
    const CurvePoint at = by_parameter(x);
    x = std::clamp(x + (point - at.position).dot(at.d1) / at.d1.squaredNorm(), 0.0, 1.0);
  }
  s = covered(x) * length_ / whole_;
  return (by_parameter(x).position - point).norm();
}

double course_length(const CourseKnot& from, const CourseKnot& to) {
  double length = (to.position - from.position).norm();
  for (int i = 0; i < max_steps; ++i) {
    const double before = length;
    length = CourseSpan(from, to, length).whole_;
    if (std::abs(length - before) <= rounding * length) {
      break;
    }
  }
  return length;
}

CurvePoint course_at(std::span<const CourseKnot> course, double s) {
  const auto after = std::upper_bound(course.begin() + 1, course.end() - 1, s,
                                      [](double at, const CourseKnot& knot) { return at < knot.s; });
  const CourseKnot& from = *(after - 1);
  return CourseSpan(from, *after).at(s - from.s);
}

}  // namespace feedscope
