#include "core/drives/drive_step.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// In time constants of a pole: up to here the power series applies.
constexpr double series_up_to = 1;
/// Up to here half of its terms suffice, to 1e-12 of the highest integrals, which count least.
constexpr double few_terms_up_to = 1.0 / 4;
/// Ratio of two real poles; closer ones would lose digits in the difference.
constexpr double far_apart = 4;

constexpr std::size_t most = SetCourse::order;
template <std::size_t count>
double sum_of(const std::array<double, 16>& series, double x) {
  // Even and odd powers can be summed in parallel.
  const double square = x * x;
  double even = 0;
  double odd = 0;
  for (std::size_t j = count; j > 0; j -= 2) {
    odd = odd * square + series[j - 1];
    even = even * square + series[j - 2];
  }
  return even + x * odd;
}

double sum_of(const std::array<double, 16>& series, double x) {
  return x <= few_terms_up_to ? sum_of<8>(series, x) : sum_of<16>(series, x);
}

/// (-1)^j/(m + j)!
constexpr std::array<double, 16> pole_series(std::size_t m) {
  std::array<double, 16> series{};
  double term = 1;
  for (std::size_t k = 2; k <= m; ++k) {
    term /= static_cast<double>(k);
  }
  for (std::size_t j = 0; j < series.size(); ++j) {
    series[j] = term;
    term /= -static_cast<double>(m + j + 1);
  }
  return series;
}

}  // namespace

DriveStep::DriveStep(const DriveLaw& law, double time, std::size_t degree)
    : time_(time), degree_(degree), top_(degree <= DriveLaw::short_degree ? DriveLaw::short_degree : most) {
  for (std::size_t k = 1; k <= top_; ++k) {
    power_[k] = power_[k - 1] * time_ * SetCourse::inverse[k];
  }
  if (law.follows_exactly()) {
    std::copy_n(power_.begin(), degree_, velocity_.begin() + 1);
    kept_ = retained_ = 0;
    return;
  }
  const Integrals s = integrals(law);
  const double unfed = 1 - law.feedforward_;
  error_[1] = unfed * s[2];
  velocity_[1] = 1 - unfed * s[1];
  for (std::size_t k = 2; k <= degree_; ++k) {
    error_[k] = unfed * s[k + 1] + law.lag_ * s[k];
    velocity_[k] = power_[k - 1] - unfed * s[k] - law.lag_ * s[k - 1];
  }
  kept_ = 1 - law.gain_ * s[2];
  gained_ = law.lag_ * s[1];
  pulled_ = law.gain_ * s[1];
  retained_ = law.lag_ * s[0];
}

DriveStep::Integrals DriveStep::integrals(const DriveLaw& law) const {
  if (law.lag_ == 0) {
    return of_pole(law.gain_);
  }
  if (law.fastest_ * time_ <= series_up_to) {
    return from_series(law);
  }
  if (law.square_ <= 0 || law.fast_ <= far_apart * law.slow_) {
    return from_exponentials(law);
  }
  Integrals s = of_pole(law.slow_);
  const Integrals fast = of_pole(law.fast_);
  const double scale = 1 / (law.lag_ * (law.fast_ - law.slow_));
  for (std::size_t i = 0; i <= top_ + 1; ++i) {
    s[i] = scale * (s[i] - fast[i]);
  }
  return s;
}

DriveStep::Integrals DriveStep::from_series(const DriveLaw& law) const {
  const auto& series = top_ == most ? law.long_series_ : law.short_series_;
  const double x = law.fastest_ * time_;
  double power = 1;
  for (std::size_t k = 1; k < top_; ++k) {
    power *= time_;
  }
  Integrals s{};
  s[top_ + 1] = power * time_ * sum_of(series[0], x);
  s[top_] = power * sum_of(series[1], x);
  const double inverse_lag = 1 / law.lag_;
  for (std::size_t m = top_; m > 0; --m) {
    s[m - 1] = inverse_lag * (power_[m - 1] - s[m] - law.gain_ * s[m + 1]);
  }
  return s;
}

DriveStep::Integrals DriveStep::of_pole(double rate) const {
  const double x = rate * time_;
  Integrals s{};
  if (x > series_up_to) {
    s[1] = std::exp(-x);
    const double inverse_rate = 1 / rate;
    for (std::size_t m = 1; m <= top_; ++m) {
      s[m + 1] = inverse_rate * (power_[m - 1] - s[m]);
    }
  } else {
    static constexpr std::array<std::array<double, 16>, 2> series{pole_series(DriveLaw::short_degree),
                                                                  pole_series(most)};
    double power = 1;
    for (std::size_t k = 0; k < top_; ++k) {
      power *= time_;
    }
    s[top_ + 1] = power * sum_of(series[top_ == most ? 1 : 0], x);
    for (std::size_t m = top_; m > 0; --m) {
      s[m] = power_[m - 1] - rate * s[m + 1];
    }
  }
  s[0] = -rate * s[1];
  return s;
}

DriveStep::Integrals DriveStep::from_exponentials(const DriveLaw& law) const {
  // Terms exp(-half t) times cosh(b t) and sinh(b t)/b, or cos and sin; b = sqrt(|square|).
  const double decay = std::exp(-law.half_ * time_);
  const double b = std::sqrt(std::abs(law.square_));
  const double x = b * time_;
  double even = 0;
  double odd = 0;
  constexpr double nearly_equal = 1e-4;
  if (x < nearly_equal) {
    const double square = law.square_ * time_ * time_;
    even = decay * (1 + square / 2);
    odd = decay * time_ * (1 + square / 6);
  } else if (law.square_ > 0) {
    const double slow = std::exp(-law.slow_ * time_);
    const double fast = std::exp(-law.fast_ * time_);
    even = (slow + fast) / 2;
    odd = (slow - fast) / (2 * b);
  } else {
    even = decay * std::cos(x);
    odd = decay * std::sin(x) / b;
  }
  Integrals s{};
  s[1] = odd / law.lag_;
  s[0] = (even - law.half_ * odd) / law.lag_;
  const double inverse_gain = 1 / law.gain_;
  for (std::size_t m = 1; m <= top_; ++m) {
    s[m + 1] = inverse_gain * (power_[m - 1] - s[m] - law.lag_ * s[m - 1]);
  }
  return s;
}

}  // namespace feedscope
