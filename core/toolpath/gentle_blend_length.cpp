#include "core/toolpath/gentle_blend_length.h"

#include <algorithm>

namespace feedscope {
namespace {

constexpr double largest_h = 0.1;  // a turn of 26 degrees

/// Integrates `f` over [0, 1/2] by the 5-point Gauss-Legendre rule on panels that grow from 2^-12: for small
/// weights p + q is small at the ends.
template <class Function>
double integral_from_end(const Function& f) {
  constexpr std::array<double, 3> node{0, 0.53846931010568309, 0.90617984593866399};
  constexpr std::array<double, 3> weight{0.56888888888888889, 0.47862867049936647, 0.23692688505618909};
  constexpr int panels_of_each = 8;
  double sum = 0;
  double from = 0;
  for (double to = 0x1p-12; to <= 0.5; to *= 2) {
    const double half = (to - from) / (2 * panels_of_each);
    for (int panel = 0; panel < panels_of_each; ++panel) {
      const double middle = from + (2 * panel + 1) * half;
      sum += half * weight[0] * f(middle);
      for (std::size_t i = 1; i < node.size(); ++i) {
        sum += half * weight[i] * (f(middle - half * node[i]) + f(middle + half * node[i]));
      }
    }
    from = to;
  }
  return sum;
}

}  // namespace

GentleBlendLength::GentleBlendLength(double alpha) {
  double binomial = 1;  // C(1/2, n) (-1/2)^n
  for (std::size_t n = 0; n < terms; ++n) {
    // Both halves contribute equally, with p and q exchanged.
    factors_[n] = 2 * binomial * integral_from_end([&](double u) {
                    const double w = 1 - u;
                    const double p = 6 * u * w + alpha * w * (1 - 3 * u);
                    const double q = 6 * u * w + alpha * u * (3 * u - 2);
                    const double sum = p + q;
                    const double share = 4 * p * q / (sum * sum);
                    double power = 1;
                    for (std::size_t i = 0; i < n; ++i) {
                      power *= share;
                    }
                    return sum * power;
                  });
    binomial *= -0.5 * (0.5 - static_cast<double>(n)) / static_cast<double>(n + 1);
  }
}

std::optional<double> GentleBlendLength::over_transition(double h) const {
  if (h > largest_h) {
    return std::nullopt;
  }
  double value = 0;
  for (std::size_t n = terms; n-- > 0;) {
    value = value * h + factors_[n];
  }
  return value;
}

}  // namespace feedscope
