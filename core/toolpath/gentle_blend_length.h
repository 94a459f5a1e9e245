#pragma once

#include <array>
#include <optional>

namespace feedscope {

/// Length of cubic blends of one weight that turn gently, as a short series. BlendLength costs some thousand
/// instructions a blend, and most blends of dense programs turn by a few degrees only.
///
/// With the derivatives p(u), q(u) of the Hermite basis along the two directions, phi the angle between
/// these, and h = 1 - cos(phi), |S'|^2 = T^2 ((p + q)^2 - 2 p q h), so that
///
///     length / T = sum over n of C(1/2, n) (-h/2)^n  * integral over u of (p + q) (4 p q / (p + q)^2)^n
///
/// where 4 p q / (p + q)^2 <= 1 and >= -1/3 for 0 < alpha < 4: a term is below (h/2)^n, the remainder below
/// 1e-15.
class GentleBlendLength {
 public:
  /// `alpha`: weight of the end derivatives, in (0, 4).
  explicit GentleBlendLength(double alpha);

  /// Length over the transition T; empty where the series is too long. `h`: 1 - cos of the turn.
  std::optional<double> over_transition(double h) const;

 private:
  static constexpr std::size_t terms = 11;
  std::array<double, terms> factors_{};  ///< of the powers of h
};

}  // namespace feedscope
