#include "core/program/sinumerik/geometry/spline_path.h"

#include <algorithm>
#include <cmath>

#include "core/program/path/b_spline.h"

namespace feedscope::sinumerik {

namespace {

/// Clamped knots: the curve begins at the first point and ends at the last one. Between them are the
/// intervals of the points from number `degree` on.
std::vector<double> knots_of(const std::vector<SplinePath::Point>& points, std::size_t degree) {
  std::vector<double> knots(degree + 1, 0.0);
  for (std::size_t i = degree; i < points.size(); ++i) {
    knots.push_back(knots.back() + points[i].interval.value_or(1));
  }
  knots.insert(knots.end(), degree, knots.back());
  return knots;
}

Vec3 akima_slope(const Vec3& m1, const Vec3& m2, const Vec3& m3, const Vec3& m4) {
  const double before = (m2 - m1).norm();
  const double behind = (m4 - m3).norm();
  return before + behind > 0 ? Vec3((behind * m2 + before * m3) / (before + behind)) : Vec3((m2 + m3) / 2);
}

/// Solves a x[i-1] + b x[i] + c x[i+1] = r for all i (Thomas).
std::vector<Vec3> solve(const std::vector<double>& a, std::vector<double> b, const std::vector<double>& c,
                        std::vector<Vec3> r) {
  const std::size_t count = b.size();
  for (std::size_t i = 1; i < count; ++i) {
    const double factor = a[i] / b[i - 1];
    b[i] -= factor * c[i - 1];
    r[i] -= factor * r[i - 1];
  }
  r[count - 1] /= b[count - 1];
  for (std::size_t i = count - 1; i-- > 0;) {
    r[i] = (r[i] - c[i] * r[i + 1]) / b[i];
  }
  return r;
}

}  // namespace

double PolynomialWord::at(double parameter, double start, double interval) const {
  return start + first(start, interval) * parameter + higher(parameter);
}

double PolynomialWord::slope_at(double parameter, double start, double interval) const {
  const auto& [a2, a3, a4, a5] = coefficients;
  const double p = parameter;
  return first(start, interval) + p * (2 * a2 + p * (3 * a3 + p * (4 * a4 + p * 5 * a5)));
}

double PolynomialWord::higher(double p) const {
  const auto& [a2, a3, a4, a5] = coefficients;
  return p * p * (a2 + p * (a3 + p * (a4 + p * a5)));
}

double PolynomialWord::first(double start, double interval) const {
  return (end - start - higher(interval)) / interval;
}

void SplinePath::begin(std::string_view kind, const Point& start, const Vec3& direction) {
  kind_ = kind;
  points_.assign(1, start);
  direction_ = direction;
}

void SplinePath::set_end(std::string_view name) {
  SplineEnd& which = name.front() == 'B' ? begin_ : end_;
  const std::string_view how = name.substr(1);
  which = how == "NAT" ? SplineEnd::natural : how == "TAN" ? SplineEnd::tangent : SplineEnd::automatic;
}

void SplinePath::spans(const Vec3& direction, const TakeSpan& take) const {
  if (empty()) {
    return;
  }
  if (kind_ == "BSPLINE") {
    b_spline(take);
    return;
  }
  std::vector<double> steps;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    steps.push_back((points_[i].at - points_[i - 1].at).norm());
  }
  hermite(kind_ == "ASPLINE" ? akima_slopes(steps, direction) : cubic_slopes(steps, direction), steps, take);
}

void SplinePath::b_spline(const TakeSpan& take) const {
  const std::size_t degree = std::min<std::size_t>(static_cast<std::size_t>(degree_), points_.size() - 1);
  const std::vector<double> knots = knots_of(points_, degree);
  std::vector<Eigen::Vector4d> weighted_points;
  for (const Point& point : points_) {
    weighted_points.push_back(weighted(point.at, point.weight));
  }
  for (std::size_t span = degree; span < points_.size(); ++span) {
    if (knots[span + 1] > knots[span]) {
      take([&](double u) { return b_spline_place(weighted_points, knots, degree, span, u); }, knots[span],
           knots[span + 1], points_[span]);
    }
  }
}

void SplinePath::hermite(const std::vector<Vec3>& slopes, const std::vector<double>& steps,
                         const TakeSpan& take) const {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Vec3& from = points_[i].at;
    const Vec3& to = points_[i + 1].at;
    const Vec3 leaves = steps[i] * slopes[i];
    const Vec3 arrives = steps[i] * slopes[i + 1];
    const auto curve = [&](double u) -> CurvePlace {
      const double v = 1 - u;
      return {v * v * ((1 + 2 * u) * from + u * leaves) + u * u * ((1 + 2 * v) * to - v * arrives),
              6 * u * v * (to - from) + v * (v - 2 * u) * leaves + u * (u - 2 * v) * arrives};
    };
    take(curve, 0, 1, points_[i + 1]);
  }
}

std::vector<Vec3> SplinePath::differences(const std::vector<double>& steps) const {
  std::vector<Vec3> slopes;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    slopes.emplace_back((points_[i + 1].at - points_[i].at) / steps[i]);
  }
  return slopes;
}

std::vector<Vec3> SplinePath::akima_slopes(const std::vector<double>& steps, const Vec3& direction) const {
  std::vector<Vec3> m = differences(steps);
  if (m.size() == 1) {
    m.push_back(m[0]);
  }
  const std::size_t count = m.size();
  // Two more differences at either end, by Akima's extrapolation.
  const Vec3 first = 2 * m[0] - m[1];
  const Vec3 last = 2 * m[count - 1] - m[count - 2];
  m.insert(m.begin(), {Vec3(2 * first - m[0]), first});
  m.push_back(last);
  m.push_back(2 * last - m[m.size() - 2]);
  std::vector<Vec3> slopes;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    slopes.push_back(akima_slope(m[i], m[i + 1], m[i + 2], m[i + 3]));
  }
  if (begin_ == SplineEnd::natural) {
    slopes.front() = 1.5 * m[2] - 0.5 * slopes[1];
  } else if (begin_ == SplineEnd::tangent && !direction_.isZero()) {
    slopes.front() = direction_;
  }
  if (end_ == SplineEnd::natural) {
    slopes.back() = 1.5 * m[steps.size() + 1] - 0.5 * slopes[slopes.size() - 2];
  } else if (end_ == SplineEnd::tangent && !direction.isZero()) {
    slopes.back() = direction;
  }
  return slopes;
}

std::vector<Vec3> SplinePath::cubic_slopes(const std::vector<double>& h, const Vec3& direction) const {
  const std::vector<Vec3> m = differences(h);
  const std::size_t last = h.size();
  std::vector<double> a(last + 1, 0.0);
  std::vector<double> b(last + 1, 2.0);
  std::vector<double> c(last + 1, 0.0);
  std::vector<Vec3> r(last + 1);
  for (std::size_t i = 1; i < last; ++i) {
    a[i] = h[i];
    b[i] = 2 * (h[i - 1] + h[i]);
    c[i] = h[i - 1];
    r[i] = 3 * (h[i] * m[i - 1] + h[i - 1] * m[i]);
  }
  // Not-a-knot ends need three pieces; with fewer the ends are straight.
  const bool has_knots = last >= 3;
  if (begin_ == SplineEnd::tangent && !direction_.isZero()) {
    b[0] = 1;
    r[0] = direction_;
  } else if (begin_ == SplineEnd::automatic && has_knots) {
    const double sum = h[0] + h[1];
    b[0] = h[1];
    c[0] = sum;
    r[0] = ((h[0] + 2 * sum) * h[1] * m[0] + h[0] * h[0] * m[1]) / sum;
  } else {
    c[0] = 1;
    r[0] = 3 * m[0];
  }
  if (end_ == SplineEnd::tangent && !direction.isZero()) {
    b[last] = 1;
    r[last] = direction;
  } else if (end_ == SplineEnd::automatic && has_knots) {
    const double sum = h[last - 1] + h[last - 2];
    a[last] = sum;
    b[last] = h[last - 2];
    r[last] =
        (h[last - 1] * h[last - 1] * m[last - 2] + (2 * sum + h[last - 1]) * h[last - 2] * m[last - 1]) / sum;
  } else {
    a[last] = 1;
    r[last] = 3 * m[last - 1];
  }
  return solve(a, b, c, r);
}

}  // namespace feedscope::sinumerik
