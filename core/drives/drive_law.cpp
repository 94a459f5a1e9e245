#include "core/drives/drive_law.h"

#include <cmath>

#include "core/base/error.h"

namespace feedscope {

DriveLaw::DriveLaw(const AxisDrive& drive, char axis)
    : gain_(drive.gain.value_or(0)),
      feedforward_(drive.feedforward.value_or(0)),
      lag_(drive.lag.value_or(0)) {
  if (const Message problem = drive_problem(drive, axis); !problem.empty()) {
    throw InputError(problem);
  }
  if (gain_ == 0) {
    return;
  }
  if (lag_ == 0) {
    fastest_ = gain_;
    return;
  }
  find_poles();
  for (std::size_t i = 0; i < 2; ++i) {
    short_series_[i] = integrated_impulse(short_degree - i);
    long_series_[i] = integrated_impulse(SetCourse::order - i);
  }
}

void DriveLaw::find_poles() {
  half_ = 1 / (2 * lag_);
  const double discriminant = 1 - 4 * lag_ * gain_;
  square_ = half_ * half_ * discriminant;
  if (discriminant > 0) {
    const double root = std::sqrt(discriminant);
    slow_ = 2 * gain_ / (1 + root);
    fast_ = half_ * (1 + root);
    fastest_ = fast_;
  } else {
    fastest_ = std::sqrt(gain_ / lag_);
  }
}

/// The derivatives of S_0 at the start follow from each other: Tv S'' = -S' - Kv S, differentiated once more
/// for each order. The one of order j contributes t^(m+j)/(m+j)! to S_m.
DriveLaw::Series DriveLaw::integrated_impulse(std::size_t m) const {
  Series series{};
  double inverse_factorial = 1;
  for (std::size_t k = 2; k <= m; ++k) {
    inverse_factorial /= static_cast<double>(k);
  }
  double here = 0;  // divided by fastest_^j
  double next = 1 / (lag_ * fastest_);
  for (std::size_t j = 0; j < terms; ++j) {
    series[j] = here * inverse_factorial;
    const double after = -(next + gain_ / fastest_ * here) / (lag_ * fastest_);
    here = next;
    next = after;
    inverse_factorial /= static_cast<double>(m + j + 1);
  }
  return series;
}

}  // namespace feedscope
