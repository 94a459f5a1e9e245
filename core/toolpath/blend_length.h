#pragma once

#include <array>
#include <complex>

#include "core/toolpath/curve.h"

namespace feedscope {

/// Path length along one blend, prepared once for many queries.
///
/// The parameter range is halved until one 12-point Gauss-Legendre rule is enough for each piece, that is
/// until the zeros of the speed lie far enough from it. They are complex, and known in closed form because a
/// blend is plane. A sharply turning blend needs many halvings around the place where it almost stops, others
/// none or one. A length then takes one rule from the nearest cut; the place of a given length takes one or
/// two third-order steps from a polynomial guess. Relative error < 1e-10 for every turn.
class BlendLength {
 public:
  explicit BlendLength(const CubicBlend& blend);

  double total() const { return cuts_[count_].s; }  ///< [mm]
  double to(double u) const;                        ///< from the start, 0 <= u <= 1 [mm]
  /// Inverse of to(), clamped to [0, 1].
  double parameter_at(double s) const;

 private:
  struct Cut {
    double u;
    double s;      ///< path length there [mm]
    double slope;  ///< du/ds [1/mm]; infinite at rest, like bend
    double bend;   ///< d2u/ds2 [1/mm2]
  };
  /// |S'|^2 and its derivatives by u [mm2].
  struct Squared {
    double value, first, second;
  };
  static constexpr int max_halvings = 16;
  static constexpr std::size_t max_pieces = 4 * max_halvings;  // on either side of two zeros

  void find_zeros(const CubicBlend& blend, const std::array<Vec3, 3>& by_power);
  bool is_smooth(double from, double to) const;
  Squared squared(double u) const;
  double gauss(double from, double to) const;
  void cut(double from, double to, int halvings);
  void set_cut(std::size_t index, double u, double s);
  static double guess(const Cut& from, const Cut& to, double s);

  std::array<double, 5> powers_;               ///< |S'|^2 by powers of u - 1/2 [mm2]
  std::array<std::complex<double>, 2> zeros_;  ///< of |S'|^2, one of each conjugate pair, as u - 1/2
  std::size_t count_ = 0;                      ///< pieces
  std::array<Cut, max_pieces + 1> cuts_;
};

}  // namespace feedscope
