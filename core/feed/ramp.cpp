#include "core/feed/ramp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope {
namespace {

double covered(double v, double a, const std::array<Phase, 3>& phases) {
  Motion1d motion{0, v, a};
  for (const Phase& phase : phases) {
    motion = advance(motion, phase.jerk, phase.duration);
  }
  return motion.s;
}

}  // namespace

Motion1d advance(const Motion1d& from, double jerk, double time) {
  return {from.s + time * (from.v + time * (from.a / 2 + time * jerk / 6)),
          from.v + time * (from.a + time * jerk / 2), from.a + time * jerk};
}

double ramp_time(double v0, double v1, const RampLimits& limits) {
  const double step = std::abs(v1 - v0);
  const auto [A, J] = limits;
  return step <= A * A / J ? 2 * std::sqrt(step / J) : step / A + A / J;
}

double ramp_length(double v0, double v1, const RampLimits& limits) {
  return (v0 + v1) / 2 * ramp_time(v0, v1, limits);
}

double reachable_speed(double v0, double length, const RampLimits& limits) {
  const auto [A, J] = limits;
  const double full = A * A / J;  // smallest step that reaches A
  if (ramp_length(v0, v0 + full, limits) < length) {
    // (v1^2 - v0^2) / (2 A) + (v0 + v1) A / (2 J) = length
    const double b = full / 2;
    return -b + std::sqrt((v0 - b) * (v0 - b) + 2 * A * length);
  }
  // x^3 + 2 v0 x = length sqrt(J) with x = sqrt(v1 - v0): convex, so Newton's steps from above only decrease.
  // Each of the two terms alone gives an upper bound.
  const double rhs = length * std::sqrt(J);
  double x = 8 * v0 * v0 * v0 > rhs * rhs ? rhs / (2 * v0) : std::cbrt(rhs);
  for (int i = 0; i < 60; ++i) {
    const double step = (x * (x * x + 2 * v0) - rhs) / (3 * x * x + 2 * v0);
    if (!(step > 1e-15 * x)) {
      break;
    }
    x -= step;
  }
  return v0 + x * x;
}

std::array<Phase, 3> speed_change(double v, double a, double target, const RampLimits& limits) {
  const auto [A, J] = limits;
  // If the acceleration is simply reduced to 0 the speed becomes v + a|a| / (2 J).
  const double sign = target >= v + a * std::abs(a) / (2 * J) ? 1 : -1;
  const double step = sign * (target - v);
  const double start = sign * a;
  const double crest = std::sqrt(std::max(J * step + start * start / 2, 0.0));
  const double top = std::max(std::min(crest, A), 0.0);
  if (start > top) {  // above the limit: back to `top` first
    const double back = (start - top) / J;
    const double rest = step - (start * start - top * top) / (2 * J) - top * top / (2 * J);
    return {{{back, -sign * J}, {top > 0 ? std::max(rest / top, 0.0) : 0, 0}, {top / J, -sign * J}}};
  }
  const double gained = (2 * top * top - start * start) / (2 * J);
  const double hold = top < crest ? (step - gained) / top : 0;
  return {{{(top - start) / J, sign * J}, {hold, 0}, {top / J, -sign * J}}};
}

double SpeedProfile::duration() const {
  double sum = 0;
  for (const Phase& phase : phases) {
    sum += phase.duration;
  }
  return sum;
}

double SpeedProfile::length() const {
  Motion1d motion{0, v0, a0};
  for (std::size_t i = 0; i < phases.size(); ++i) {
    motion.a = i == held ? 0 : motion.a;
    motion = advance(motion, phases[i].jerk, phases[i].duration);
  }
  return motion.s;
}

namespace {

/// Removes a rounding error from the length: changes all speeds by the same share and keeps all times.
void fit_length(SpeedProfile& profile, double length) {
  constexpr double rounding = 1e-6;
  const double factor = length / profile.length();
  profile.feasible = std::abs(factor - 1) <= rounding;
  if (profile.feasible) {
    profile.v0 *= factor;
    profile.a0 *= factor;
    profile.peak *= factor;
    for (Phase& phase : profile.phases) {
      phase.jerk *= factor;
    }
  }
}

/// Peak above both `v0` and `v1` whose ramps have the total length `length`, at most `high`, for which they
/// are longer; `room`: length left by the ramp between the two. Solved for q, the root of the step from the
/// faster end: the length is convex in it, so Newton's steps from above only decrease. Each of its terms
/// alone gives an upper bound.
double peak_between(double v0, double v1, double length, double room, double high, const RampLimits& limits) {
  const auto [A, J] = limits;
  const double fast = std::max(v0, v1);
  const double slow = std::min(v0, v1);
  const double apart = fast - slow;
  const double full = A * A / J;  // smallest step that reaches A
  const double root_of_jerk = std::sqrt(J);
  const double scaled = length * root_of_jerk;
  const double wide = std::min(scaled / (3 * fast + slow), room * root_of_jerk / (2 * fast));
  double q = std::sqrt(std::min(high - fast, wide * wide));
  if (2 * q * q * q > scaled) {
    q = std::cbrt(scaled / 2);
  }
  const double by_root = 2 / root_of_jerk;
  constexpr double rounding = 1e-15;
  for (int i = 0; i < 60; ++i) {
    const double step = q * q;
    const double other = step + apart;
    const double root = apart > 0 ? std::sqrt(other) : q;
    const bool gentle = step <= full;
    const bool other_gentle = other <= full;
    const double time = gentle ? by_root * q : step / A + A / J;
    const double other_time = other_gentle ? by_root * root : other / A + A / J;
    const double slope = gentle ? by_root : 2 * q / A;
    const double other_slope = other_gentle ? (root > 0 ? by_root * q / root : by_root) : 2 * q / A;
    const double mean = fast + step / 2;
    const double other_mean = slow + other / 2;
    const double excess = mean * time + other_mean * other_time - length;
    const double newton = excess / (q * (time + other_time) + mean * slope + other_mean * other_slope);
    if (!(excess > rounding * length && newton > rounding * q)) {
      break;
    }
    q -= newton;
  }
  return fast + q * q;
}

SpeedProfile plan_unfitted(double v0, double a0, double v1, double length, double ceiling,
                           const RampLimits& limits) {
  constexpr double rounding = 1e-12;
  if (a0 == 0 && std::abs(v1 - v0) <= rounding * v0) {
    v0 = v1;  // a ramp would take the root of the difference in time
  }
  SpeedProfile profile;
  profile.v0 = v0;
  profile.a0 = a0;
  const auto build = [&](double peak) {
    const auto up = speed_change(v0, a0, peak, limits);
    const auto down = speed_change(peak, 0, v1, limits);
    profile.peak = peak;
    profile.phases = {up[0], up[1], up[2], Phase{}, down[0], down[1], down[2]};
  };
  const auto excess = [&](double peak) {
    const double first =
        a0 == 0 ? ramp_length(v0, peak, limits) : covered(v0, a0, speed_change(v0, a0, peak, limits));
    return first + ramp_length(peak, v1, limits) - length;
  };

  const double settled = v0 + a0 * std::abs(a0) / (2 * limits.jerk);
  const double tolerance = 1e-12 * (length + 1e-3);
  double high = std::max(ceiling, v1);
  const double above = excess(high);
  if (above <= 0) {
    build(high);
    profile.phases[3] = {-above / high, 0};
    return profile;
  }
  // From the settled speed on the length increases with the peak; below it braking takes more and more
  // length.
  double low = std::max(settled, v1);
  const double at_low = low <= high ? excess(low) : tolerance;
  const bool above_both = low <= high && at_low <= tolerance;
  if (!above_both) {
    low = v1;
    high = std::max(settled, v1);
    if (excess(low) > tolerance) {
      build(low);
      return profile;
    }
  }
  if (above_both && a0 == 0) {
    double peak = peak_between(v0, v1, length, std::max(-at_low, 0.0), high, limits);
    double rest = -excess(peak);
    for (double ulps = 1; rest < 0 && peak > low; ulps *= 4) {  // rounding of the peak only
      peak = std::max(low, peak * (1 - ulps * std::numeric_limits<double>::epsilon()));
      rest = -excess(peak);
    }
    build(peak);
    profile.phases[3] = {peak > 0 ? std::max(rest, 0.0) / peak : 0, 0};
    return profile;
  }
  // Illinois' regula falsi keeps the bracket; a few steps suffice.
  double f_low = excess(low);
  double f_high = excess(high);
  double peak = low;
  int side = 0;
  for (int i = 0; i < 200 && f_low < 0 && high - low > 1e-14 * high; ++i) {
    peak = (low * f_high - high * f_low) / (f_high - f_low);
    if (!(peak > low && peak < high) || i > 40) {
      peak = (low + high) / 2;
    }
    const double f = excess(peak);
    if (f <= 0 && f >= -1e-15 * (length + 1e-3)) {
      low = peak;
      break;
    }
    if (f < 0) {
      low = peak;
      f_low = f;
      f_high = side == -1 ? f_high / 2 : f_high;
      side = -1;
    } else {
      high = peak;
      f_high = f;
      f_low = side == 1 ? f_low / 2 : f_low;
      side = 1;
    }
  }
  // A peak close to v0 or v1 does not determine the length accurately, which depends on its root: the rest is
  // run at the peak.
  build(low);
  profile.phases[3] = {low > 0 ? std::max(-excess(low), 0.0) / low : 0, 0};
  return profile;
}

}  // namespace

SpeedProfile plan_profile(double v0, double a0, double v1, double length, double ceiling,
                          const RampLimits& limits) {
  SpeedProfile profile = plan_unfitted(v0, a0, v1, length, ceiling, limits);
  fit_length(profile, length);
  const bool turns_back = a0 < 0 && v0 - a0 * a0 / (2 * limits.jerk) < 0;
  profile.feasible = profile.feasible && !turns_back;
  return profile;
}

double profile_peak(double v0, double v1, double length, double ceiling, const RampLimits& limits) {
  const auto excess = [&](double peak) {
    return ramp_length(v0, peak, limits) + ramp_length(peak, v1, limits) - length;
  };
  const double high = std::max(ceiling, v1);
  if (excess(high) <= 0) {
    return high;
  }
  const double low = std::max(v0, v1);
  if (low <= high) {
    if (const double at_low = excess(low); at_low <= 0) {
      return peak_between(v0, v1, length, -at_low, high, limits);
    }
  }
  return plan_profile(v0, 0, v1, length, ceiling, limits).peak;
}

double profile_time(double v0, double v1, double length, double ceiling, const RampLimits& limits) {
  const double peak = profile_peak(v0, v1, length, ceiling, limits);
  if (!(limits.acceleration > 0) && (peak != v0 || peak != v1)) {
    return std::numeric_limits<double>::infinity();
  }
  const double rest = length - ramp_length(v0, peak, limits) - ramp_length(peak, v1, limits);
  return ramp_time(v0, peak, limits) + ramp_time(peak, v1, limits) +
         (peak > 0 ? std::max(rest, 0.0) / peak : 0);
}

}  // namespace feedscope
