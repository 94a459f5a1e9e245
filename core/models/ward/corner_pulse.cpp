#include "core/models/ward/corner_pulse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/roots.h"

namespace feedscope {
namespace {

/// d/da of corner_distance, times 1/F: only for Newton steps, which stay in a bracket.
double distance_slope(int filters, double a) {
  if (filters == 2) {
    return (1 + 3 * a * a - 4 * a * a * a) / 6;
  }
  if (a <= 2.0 / 3) {
    return (78 + a * a * a * (324 - 405 * a)) / 384;
  }
  const double p = -48 + a * (288 + a * (-648 + a * (648 - 162 * a)));
  const double dp = 288 + a * (-1296 + a * (1944 - 648 * a));
  return (78 - p + (1 - a) * dp) / 384;
}

constexpr RootTolerance pulse_tolerance{.relative = 1e-14, .steps = 60};

/// x in (0, pi) with 1 - sin(x)/x = `loss`, which is in (0, 1).
double inverse_sinc_loss(double loss) {
  const auto excess = [&](double x) {
    const double y = x * x;
    return x < 0.5 ? y / 6 * (1 - y / 20 * (1 - y / 42 * (1 - y / 72 * (1 - y / 110)))) - loss
                   : 1 - std::sin(x) / x - loss;
  };
  return rising_root({0, std::numbers::pi}, std::min(std::sqrt(6 * loss), std::numbers::pi), pulse_tolerance,
                     [&](double x) {
                       return ValueAndSlope{excess(x), (std::sin(x) - x * std::cos(x)) / (x * x)};
                     });
}

}  // namespace

double corner_distance(int filters, double a) {
  if (filters == 2) {
    return a * (1 + a * a * (1 - a)) / 6;
  }
  if (a <= 2.0 / 3) {
    return (78 * a + 81 * (1 - a) * a * a * a * a) / 384;
  }
  return (78 * a + (1 - a) * (-48 + a * (288 + a * (-648 + a * (648 - 162 * a))))) / 384;
}

double corner_speed_share(int filters, double a) {
  if (filters == 2) {
    return a * (1 + a * (1 - a)) / 2;
  }
  if (a <= 2.0 / 3) {
    return (24 * a + 27 * (1 - a) * a * a * a) / 48;
  }
  return (24 * a + (1 - a) * (24 + a * (-108 + a * (162 - 54 * a)))) / 48;
}

double corner_speed(int filters, double filter_time, const CornerLegs& legs, double tolerance) {
  const double top = std::min(legs.feed_before, legs.feed_after);
  const double wanted = tolerance / (filter_time * std::sin(legs.turn / 2));
  const auto distance = [&](double v) {
    return legs.feed_before * corner_distance(filters, v / legs.feed_before) +
           legs.feed_after * corner_distance(filters, v / legs.feed_after);
  };
  if (distance(top) <= wanted) {
    return top;
  }
  return rising_root(
      {0, top}, std::min(top / 2, wanted / (2 * distance_slope(filters, 0))), pulse_tolerance, [&](double v) {
        return ValueAndSlope{distance(v) - wanted, distance_slope(filters, v / legs.feed_before) +
                                                       distance_slope(filters, v / legs.feed_after)};
      });
}

double turn_gain(int filters, double x) {
  const double sinc = x > 0 ? std::sin(x) / x : 1;
  return filters == 2 ? sinc * sinc : sinc * sinc * sinc;
}

double arc_speed(int filters, double filter_time, const Arc& arc, double tolerance) {
  if (tolerance >= arc.radius) {
    return std::numeric_limits<double>::infinity();
  }
  const double loss = -std::expm1(std::log1p(-tolerance / arc.radius) / filters);
  return 2 * inverse_sinc_loss(loss) / filter_time * arc.length_per_radian();
}

}  // namespace feedscope
