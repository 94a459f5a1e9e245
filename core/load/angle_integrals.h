#pragma once

namespace feedscope {

/// Integrals from 0 to an angle of a tooth in [0, pi], for a cutting force proportional to sin^q of the
/// angle.
class AngleIntegrals {
 public:
  /// `exponent` q: in (0, 1]; 1 in closed form, others by quadrature to 1e-10.
  explicit AngleIntegrals(double exponent);

  double of_power(double angle) const;               ///< of sin^q
  double of_power_times_sine(double angle) const;    ///< of sin^(q + 1)
  double of_power_times_cosine(double angle) const;  ///< of sin^q cos
  /// sin^q itself; 0 outside of the immersion of any tool.
  double power(double angle) const;

 private:
  double of_any_power(double exponent, double half, double angle) const;

  double exponent_;
  double half_power_ = 0;  ///< of_power(pi/2)
  double half_sine_ = 0;   ///< of_power_times_sine(pi/2)
};

}  // namespace feedscope
