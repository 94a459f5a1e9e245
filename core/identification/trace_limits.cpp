#include "core/identification/trace_limits.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace feedscope {
namespace {

constexpr double share_reached = 0.995;  // quantile of the samples: single ones are not representative
constexpr double shortest = 8e-3;        // [s] used for differences

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) {
    return 0;
  }
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace

AxisVector<AxisReach> reach_of(const Trace& trace, double noise) {
  AxisVector<AxisReach> reach;
  const double period = std::max(trace.period, 1e-6);
  const auto width = static_cast<std::size_t>(std::clamp(std::ceil(shortest / period), 1.0, 1e6));
  const double span = static_cast<double>(width) * period;
  for (std::size_t axis = 0; axis < trace.place.size(); ++axis) {
    const std::vector<double>& x = trace.place[axis];
    std::vector<double> velocity;
    std::vector<double> acceleration;
    std::vector<double> jerk;
    for (std::size_t i = 3 * width; i < x.size(); ++i) {
      const double a = x[i];
      const double b = x[i - width];
      const double c = x[i - 2 * width];
      const double d = x[i - 3 * width];
      if (std::abs(a - d) <= 6 * noise + 1e-4) {
        continue;  // at rest
      }
      velocity.push_back(std::abs(a - b) / span);
      acceleration.push_back(std::abs(a - 2 * b + c) / (span * span));
      jerk.push_back(std::abs(a - 3 * b + 3 * c - d) / (span * span * span));
    }
    const std::size_t place = axis;
    if (place < reach.size()) {
      reach[place] = {quantile(velocity, share_reached), quantile(acceleration, share_reached),
                      quantile(jerk, share_reached)};
    }
  }
  return reach;
}

}  // namespace feedscope
