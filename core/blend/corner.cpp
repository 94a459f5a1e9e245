#include "core/blend/corner.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

double used_tolerance(const Vec3& in, const Vec3& out, const CornerRule& rule) {
  // A component below the limit for straight is rounding of the coordinates, not a motion of the axis.
  bool reverses = false;
  for (int j = 0; j < 3; ++j) {
    reverses =
        reverses || (in[j] * out[j] < 0 && std::min(std::abs(in[j]), std::abs(out[j])) > straight_angle);
  }
  const double beta = rule.beta > 0 ? rule.beta : (reverses ? 0.6 : 0.8);
  return beta * rule.tolerance;
}

Corner lay_corner(const Vec3& in, const Vec3& out, double longest, const CornerRule& rule) {
  const double half_sine = (out - in).norm() / 2;  // sin(phi/2)
  Corner corner;
  corner.turn = turn_angle(in, out);
  corner.transition = std::min(4 * used_tolerance(in, out, rule) / ((4 - rule.alpha) * half_sine), longest);
  corner.epsilon = blend_epsilon(in, out, corner.transition, rule.alpha);
  return corner;
}

double blend_epsilon(const Vec3& in, const Vec3& out, double transition, double alpha) {
  const double half_sine = (out - in).norm() / 2;  // sin(phi/2)
  return transition * (4 - alpha) * half_sine / 4;
}

Corner lay_arc_corner(const Vec3& in, const Vec3& out, double longest, const CornerRule& rule) {
  Corner corner;
  corner.turn = turn_angle(in, out);
  const double slope = std::tan(corner.turn / 4);  // eps / T
  corner.transition = std::min(
      {used_tolerance(in, out, rule) / slope, longest, largest_arc_radius * std::tan(corner.turn / 2)});
  corner.epsilon = corner.transition * slope;
  return corner;
}

Arc corner_arc(const Vec3& corner, const Vec3& in, const Vec3& out, double transition) {
  const Vec3 inwards = (out - in.dot(out) * in).normalized();
  Arc arc;
  arc.sweep = turn_angle(in, out);
  arc.radius = transition / std::tan(arc.sweep / 2);
  arc.center = corner - transition * in + arc.radius * inwards;
  arc.x = -inwards;
  arc.y = in;
  arc.rise = Vec3::Zero();
  return arc;
}

CubicBlend corner_blend(const Vec3& corner, const Vec3& in, const Vec3& out, double transition,
                        double alpha) {
  return {corner - transition * in, corner, corner + transition * out, alpha};
}

BlendShape::BlendShape(const Vec3& in, const Vec3& out, double transition, double alpha)
    : first_(in), cos_(in.dot(out)), transition_(transition), alpha_(alpha) {
  const Vec3 across = out - cos_ * in;
  sin_ = across.norm();
  second_ = across / sin_;
}

BlendShape::Point BlendShape::at(double u) const {
  // S = P + T (p(u) U + q(u) V) with the Hermite basis; first, second and third derivatives of p and q.
  const double w = 1 - u;
  const double p1 = 6 * u * w + alpha_ * (1 - 4 * u + 3 * u * u);
  const double q1 = 6 * u * w + alpha_ * (3 * u * u - 2 * u);
  const double p2 = 6 - 12 * u + alpha_ * (6 * u - 4);
  const double q2 = 6 - 12 * u + alpha_ * (6 * u - 2);
  const double p3 = -12 + 6 * alpha_;

  // In the orthonormal frame (first_, second_), V = (cos, sin); q3 = p3.
  const double x1 = p1 + q1 * cos_, y1 = q1 * sin_;
  const double x2 = p2 + q2 * cos_, y2 = q2 * sin_;
  const double x3 = p3 * (1 + cos_), y3 = p3 * sin_;

  const double norm = std::sqrt(x1 * x1 + y1 * y1);
  const double inverse = 1 / norm;
  const double dnorm = (x1 * x2 + y1 * y2) * inverse;
  Point point;
  point.sigma = transition_ * norm;
  point.dsigma = transition_ * dnorm;
  point.ddsigma = transition_ * (x2 * x2 + y2 * y2 + x1 * x3 + y1 * y3 - dnorm * dnorm) * inverse;
  const double cross = x1 * y2 - y1 * x2;
  const double bend = inverse * inverse * inverse / transition_;
  point.k = cross * bend;
  point.dk_ds = (x1 * y3 - y1 * x3 - 3 * cross * dnorm * inverse) * bend * inverse / transition_;
  point.tangent = (x1 * inverse) * first_ + (y1 * inverse) * second_;
  point.normal = (-y1 * inverse) * first_ + (x1 * inverse) * second_;
  return point;
}

BlendShape::Bend BlendShape::bend_at(double u) const {
  const double basis = 6 * u * (1 - u);
  const double p1 = basis + alpha_ * (1 - 4 * u + 3 * u * u);
  const double q1 = basis + alpha_ * (3 * u * u - 2 * u);
  const double p2 = 6 - 12 * u + alpha_ * (6 * u - 4);
  const double q2 = 6 - 12 * u + alpha_ * (6 * u - 2);
  const double x1 = p1 + q1 * cos_, y1 = q1 * sin_;
  const double squared = x1 * x1 + y1 * y1;
  const double norm = std::sqrt(squared);
  // x1 y2 - y1 x2
  return {transition_ * norm, (p1 * q2 - q1 * p2) * sin_ / (squared * norm * transition_)};
}

Vec3 BlendShape::largest_tangent() const {
  // The tangent turns from one direction to the other: p cos(a) + q sin(a) on each axis, 0 <= a <= phi < pi.
  Vec3 largest;
  for (int j = 0; j < 3; ++j) {
    const double p = first_[j], q = second_[j];
    const double slope_at_end = q * cos_ - p * sin_;
    const bool crest = q * slope_at_end < 0;
    largest[j] = crest ? std::sqrt(p * p + q * q) : std::max(std::abs(p), std::abs(p * cos_ + q * sin_));
  }
  return largest;
}

double min_radius(const BlendShape& shape) {
  constexpr int intervals = 32;
  double largest = 0;
  for (int i = 0; i <= intervals; ++i) {
    largest = std::max(largest, shape.at(static_cast<double>(i) / intervals).k);
  }
  return 1 / largest;
}

}  // namespace feedscope
