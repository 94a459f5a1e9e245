#include "core/drives/blend_course.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

using Rule = Eigen::Array<double, 8, 1>;

/// Nodes and weights of the 8-point Gauss-Legendre rule on [-1, 1].
alignas(Rule) constexpr std::array<double, 8> gauss_nodes{
    -0.96028985649753623, -0.79666647741362674, -0.52553240991632899, -0.18343464249564980,
    0.18343464249564980,  0.52553240991632899,  0.79666647741362674,  0.96028985649753623};
alignas(Rule) constexpr std::array<double, 8> gauss_weights{
    0.10122853629037626, 0.22238103445337447, 0.31370664587788729, 0.36268378337836198,
    0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626};

/// Share of the blend: lengths closer to an end count as the end.
constexpr double rounding = 1e-12;

}  // namespace

void BlendCourse::enter(const CubicBlend& blend, double length, const Part& part) {
  const bool goes_on = length_ > 0 && part.element == part_.element &&
                       (blend.start - blend_.start).isZero(0) && is_reached(part.q);
  part_ = part;
  if (!goes_on) {
    blend_ = blend;
    length_ = length;
    const CurvePoint middle = blend.at(0.5);
    const Vec3& a = middle.d1;
    const Vec3& b = middle.d2;
    const Vec3 c = middle.d3 / 2;
    squared_ = {a.squaredNorm(), 2 * a.dot(b), b.squaredNorm() + 2 * a.dot(c), 2 * b.dot(c), c.squaredNorm()};
  }
  const LawPoint start = law_at(part, 0);
  const double u = goes_on                       ? reached_.parameter[0]
                   : part.q <= rounding * length ? 0
                                                 : blend.parameter_at(part.q);
  reached_ = place_at(u, start);
  const double share = (law_at(part, part.duration).q - part.q) / length;
  duration_ = part.duration / std::ceil(std::max(share * spans_, rounding));
}

bool BlendCourse::is_reached(double s) const {
  constexpr double same = 1e-9;
  return std::abs(s - reached_.s) <= same * length_;
}

/// Series in time: s' times |S'|^2 = q0 + q1 w + ... + q4 w^4 to the power -1/2, with w = u - u0.
BlendCourse::Place BlendCourse::place_at(double u, const LawPoint& law) const {
  const CurvePoint at = blend_.at(u);
  const double q0 = at.d1.squaredNorm();
  const double q1 = 2 * at.d1.dot(at.d2);
  const double q2 = at.d2.squaredNorm() + at.d1.dot(at.d3);
  const double q3 = at.d2.dot(at.d3);
  // g = |S'|^-1: from q g' = -q'/2 g.
  const double g0 = 1 / std::sqrt(q0);
  const double r = 1 / q0;
  const double w1 = law.v * g0;
  const double p1 = q1 * w1 * r;
  const double g1 = -0.5 * p1 * g0;
  const double w2 = (law.v * g1 + law.a * g0) / 2;
  const double p2 = (q1 * w2 + q2 * w1 * w1) * r;
  const double g2 = -0.75 * p1 * g1 - 0.5 * p2 * g0;
  const double w3 = (law.v * g2 + law.a * g1 + law.j / 2 * g0) / 3;
  const double p3 = (q1 * w3 + 2 * q2 * w1 * w2 + q3 * w1 * w1 * w1) * r;
  const double g3 = -(5.0 / 6) * p1 * g2 - (2.0 / 3) * p2 * g1 - 0.5 * p3 * g0;
  const double w4 = (law.v * g3 + law.a * g2 + law.j / 2 * g1) / 4;
  const double square = w1 * w1;
  Place place;
  place.s = law.q;
  place.parameter = {u, w1, w2, w3, w4};
  place.derivatives = {at.position, w1 * at.d1, 2 * w2 * at.d1 + square * at.d2,
                       6 * w3 * at.d1 + 6 * w1 * w2 * at.d2 + square * w1 * at.d3,
                       24 * w4 * at.d1 + (24 * w1 * w3 + 12 * w2 * w2) * at.d2 + 12 * square * w2 * at.d3};
  return place;
}

double BlendCourse::speed_squared(double u) const {
  const double w = u - 0.5;
  const auto& p = squared_;
  return std::max(0.0, p[0] + w * (p[1] + w * (p[2] + w * (p[3] + w * p[4]))));
}

double BlendCourse::length_between(double from, double to) const {
  const Eigen::Map<const Rule, Eigen::AlignedMax> nodes(gauss_nodes.data());
  const Eigen::Map<const Rule, Eigen::AlignedMax> weights(gauss_weights.data());
  const double half = (to - from) / 2;
  const Rule w = (from + to - 1) / 2 + half * nodes;
  const auto& p = squared_;
  const Rule squares = p[0] + w * (p[1] + w * (p[2] + w * (p[3] + w * p[4])));
  return half * (weights * squares.max(0.0).sqrt()).sum();
}

double BlendCourse::parameter_at(const LawPoint& law, const Place& from, double h) const {
  if (law.q >= length_ * (1 - rounding)) {
    return 1;
  }
  const Parameter& p = from.parameter;
  const double target = law.q - from.s;
  double u = std::clamp(p[0] + h * (p[1] + h * (p[2] + h * (p[3] + h * p[4]))), p[0], 1.0);
  constexpr int most_steps = 8;
  constexpr double small = 1e-3;  // the remaining error is of the order of its cube
  for (int i = 0; i < most_steps; ++i) {
    const double square = speed_squared(u);
    const double w = u - 0.5;
    const double slope = squared_[1] + w * (2 * squared_[2] + w * (3 * squared_[3] + w * 4 * squared_[4]));
    const double newton = (target - length_between(p[0], u)) / std::sqrt(square);
    const double step = newton * (1 - newton * slope / (4 * square));
    u = std::clamp(u + step, p[0], 1.0);
    if (std::abs(step) < small * (u - p[0])) {
      break;
    }
  }
  return u;
}

/// Error in the middle of `span` [mm].
double BlendCourse::error_of(const SetSpan& span, const Place& start, double from) const {
  const double h = span.duration / 2;
  const double u = parameter_at(law_at(part_, from + h), start, h);
  return (blend_.at(u).position - span.at(h)).cwiseAbs().maxCoeff();
}

bool BlendCourse::fill(SetSpan& span, double from) {
  constexpr int most_tries = 12;
  constexpr double most_spans = 1000;
  if (const LawPoint law = law_at(part_, from); !is_reached(law.q)) {
    reached_ = place_at(blend_.parameter_at(law.q), law);
  }
  const Place start = reached_;
  double h = duration_;
  for (int tries = 0; tries < most_tries; ++tries) {
    if (part_.duration - from < 1.1 * h) {
      h = part_.duration - from;
    }
    const LawPoint law = law_at(part_, from + h);
    const Place end = place_at(parameter_at(law, start, h), law);
    span.begin(start.derivatives[0], SetCourse::order, h);
    for (std::size_t axis = 0; axis < span.axes.size(); ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      auto& derivative = span.axes[axis].derivative;
      for (std::size_t k = 1; k <= SetCourse::met; ++k) {
        derivative[k] = start.derivatives[k][i];
      }
      const auto& d = end.derivatives;
      meet_end(derivative, {d[0][i], d[1][i], d[2][i], d[3][i], d[4][i]}, h);
    }
    const double error = error_of(span, start, from);
    if (error <= tolerance_) {
      const double share = end.parameter[0] - start.parameter[0];
      if (error < tolerance_ / 8 && share * spans_ > 0.7) {
        spans_ *= 0.95;
      }
      reached_ = end;
      return true;
    }
    spans_ = std::min(1.1 * spans_, most_spans);
    h *= error < 1e10 * tolerance_ ? std::clamp(0.8 * std::pow(tolerance_ / error, 0.1), 0.2, 0.9) : 0.2;
    duration_ = h;
  }
  return false;
}

}  // namespace feedscope
