#include "core/toolpath/blend_length.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

using Rule = Eigen::Array<double, 12, 1>;

/// Nodes and weights of the 12-point Gauss-Legendre rule on [-1, 1].
alignas(Rule) constexpr std::array<double, 12> gauss_nodes{
    -0.98156063424671924, -0.90411725637047480, -0.76990267419430469, -0.58731795428661748,
    -0.36783149899818018, -0.12523340851146891, 0.12523340851146891,  0.36783149899818018,
    0.58731795428661748,  0.76990267419430469,  0.90411725637047480,  0.98156063424671924};
alignas(Rule) constexpr std::array<double, 12> gauss_weights{
    0.04717533638651183, 0.10693932599531843, 0.16007832854334622, 0.20316742672306592,
    0.23349253653835481, 0.24914704581340277, 0.24914704581340277, 0.23349253653835481,
    0.20316742672306592, 0.16007832854334622, 0.10693932599531843, 0.04717533638651183};

constexpr double nowhere = 1e150;

/// numerator / denominator; nowhere for a denominator of 0.
std::complex<double> quotient(std::complex<double> numerator, std::complex<double> denominator) {
  const double squared = std::norm(denominator);
  return squared > 0 ? numerator * std::conj(denominator) / squared : nowhere;
}

/// Root with a real part >= 0, without the overflow handling that makes the standard function slow.
std::complex<double> root_of(std::complex<double> z) {
  const double major = std::sqrt((std::sqrt(std::norm(z)) + std::abs(z.real())) / 2);
  if (!(major > 0)) {
    return 0;
  }
  const double minor = z.imag() / (2 * major);
  return z.real() >= 0 ? std::complex(major, minor)
                       : std::complex(std::abs(minor), std::copysign(major, minor));
}

}  // namespace

BlendLength::BlendLength(const CubicBlend& blend) {
  // Expanded around the middle, where a sharp blend almost stops: there the speed must not be a difference of
  // large terms.
  const CurvePoint middle = blend.at(0.5);
  const std::array<Vec3, 3> h{middle.d1, middle.d2, middle.d3 / 2};
  powers_ = {h[0].squaredNorm(), 2 * h[0].dot(h[1]), h[1].squaredNorm() + 2 * h[0].dot(h[2]),
             2 * h[1].dot(h[2]), h[2].squaredNorm()};
  find_zeros(blend, h);
  set_cut(0, 0, 0);
  cut(0, 1, max_halvings);
}

/// In the plane of the blend, S' as a complex number is a polynomial of second degree.
void BlendLength::find_zeros(const CubicBlend& blend, const std::array<Vec3, 3>& by_power) {
  const Vec3 along = (blend.corner - blend.start).normalized();
  const Vec3 out = blend.end - blend.corner;
  const Vec3 across = (out - out.dot(along) * along).normalized();
  std::array<std::complex<double>, 3> c;
  std::ranges::transform(by_power, c.begin(),
                         [&](const Vec3& h) { return std::complex<double>(h.dot(along), h.dot(across)); });
  const std::complex<double> root = root_of(c[1] * c[1] - 4.0 * c[2] * c[0]);
  const bool same_way = (std::conj(c[1]) * root).real() >= 0;
  const std::complex<double> sum = -0.5 * (same_way ? c[1] + root : c[1] - root);
  zeros_ = {quotient(sum, c[2]), quotient(c[0], sum)};
}

/// True if the zeros lie outside the ellipse around the interval within which one rule is exact to 1e-13.
bool BlendLength::is_smooth(double from, double to) const {
  constexpr double wide = 2;  // longest axis of the ellipse over the interval
  return std::ranges::all_of(zeros_, [&](const std::complex<double>& zero) {
    const double across = zero.imag() * zero.imag();
    const double before = zero.real() - (from - 0.5);
    const double behind = zero.real() - (to - 0.5);
    return std::sqrt(before * before + across) + std::sqrt(behind * behind + across) >= wide * (to - from);
  });
}

void BlendLength::cut(double from, double to, int halvings) {
  if (halvings == 0 || is_smooth(from, to)) {
    set_cut(count_ + 1, to, cuts_[count_].s + gauss(from, to));
    ++count_;
    return;
  }
  const double middle = (from + to) / 2;
  cut(from, middle, halvings - 1);
  cut(middle, to, halvings - 1);
}

void BlendLength::set_cut(std::size_t index, double u, double s) {
  const Squared speed = squared(u);
  const double slope = 1 / std::sqrt(speed.value);
  cuts_[index] = {u, s, slope, -speed.first / (2 * speed.value * speed.value)};
}

BlendLength::Squared BlendLength::squared(double u) const {
  const auto& [p0, p1, p2, p3, p4] = powers_;
  const double w = u - 0.5;
  return {std::max(0.0, p0 + w * (p1 + w * (p2 + w * (p3 + w * p4)))),
          p1 + w * (2 * p2 + w * (3 * p3 + w * 4 * p4)), 2 * p2 + w * (6 * p3 + w * 12 * p4)};
}

double BlendLength::gauss(double from, double to) const {
  const Eigen::Map<const Rule, Eigen::AlignedMax> nodes(gauss_nodes.data());
  const Eigen::Map<const Rule, Eigen::AlignedMax> weights(gauss_weights.data());
  const double half = (to - from) / 2;
  const Rule w = (from + to - 1) / 2 + half * nodes;
  const Rule squares = powers_[0] + w * (powers_[1] + w * (powers_[2] + w * (powers_[3] + w * powers_[4])));
  return half * (weights * squares.max(0.0).sqrt()).sum();
}

double BlendLength::to(double u) const {
  std::size_t piece = 0;
  while (piece + 1 < count_ && cuts_[piece + 1].u < u) {
    ++piece;
  }
  return cuts_[piece].s + gauss(cuts_[piece].u, u);
}

/// Polynomial of fifth degree in s through the places, slopes and bends of both cuts.
double BlendLength::guess(const Cut& from, const Cut& to, double s) {
  const double span = to.s - from.s;
  const double chord = to.u - from.u;
  const double t = (s - from.s) / span;
  const double r = 1 - t;
  // Deviation from the chord: t r g(t).
  const double rise = from.slope * span - chord;
  const double fall = to.slope * span - chord;
  const double g = r * r * (rise * (1 + 3 * t) + t * from.bend * span * span / 2) -
                   t * t * (fall * (1 + 3 * r) - r * to.bend * span * span / 2);
  const double u = from.u + t * chord + t * r * g;
  return u > from.u && u < to.u ? u : from.u + t * chord;
}

double BlendLength::parameter_at(double s) const {
  if (!(s > 0 && total() > 0)) {
    return 0;
  }
  if (s >= total()) {
    return 1;
  }
  std::size_t piece = 0;
  while (piece + 1 < count_ && cuts_[piece + 1].s < s) {
    ++piece;
  }
  const Cut& start = cuts_[piece];
  // Steps stay inside a bracket because the speed may vanish on the way.
  double low = start.u;
  double high = cuts_[piece + 1].u;
  double u = guess(start, cuts_[piece + 1], s);
  const double tolerance = 1e-14 * total();
  const double by_width = 1 / ((high - low) * (high - low));
  for (int step = 0; step < 100; ++step) {
    const double missing = s - (start.s + gauss(start.u, u));
    if (std::abs(missing) <= tolerance) {
      break;
    }
    (missing < 0 ? high : low) = u;
    const Squared speed = squared(u);
    const double newton = missing / std::sqrt(speed.value);
    const double steepness = speed.first / speed.value;
    double next = u + newton * (1 - newton * steepness / 4);
    if (!(next > low && next < high)) {
      next = (low + high) / 2;
    } else {
      // The error is proportional to the cube of the step: not worth another quadrature.
      constexpr double small = 1e-11;
      const double roughness = by_width + steepness * steepness + std::abs(speed.second) / speed.value;
      if (newton * newton * roughness < small) {
        return next;
      }
    }
    if (next == u) {
      break;
    }
    u = next;
  }
  return u;
}

}  // namespace feedscope
