#include "core/models/essid/blend_law.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/roots.h"

namespace feedscope {
namespace {

struct Sample {
  double u, du, ddu;
};

Sample step(const Sample& from, double jerk, double time) {
  return {from.u + time * (from.du + time * (from.ddu / 2 + time * jerk / 6)),
          from.du + time * (from.ddu + time * jerk / 2), from.ddu + time * jerk};
}

/// Time to u = 1 within a step that ends beyond it.
double time_to_end(const Sample& from, double jerk, double period) {
  constexpr int halvings = 60;
  return halve({0, period}, halvings, [&](double time) { return step(from, jerk, time).u < 1; }).high;
}

/// Row of eq 24 that is closest to its limit, as a share of it.
struct Use {
  double share = 0;
  Cause cause;

  void add(double value, const Vec3& limit_inverse, const Vec3& direction, CauseKind kind) {
    constexpr double rounding = 1 + 1e-12;
    if (std::abs(value) * rounding * limit_inverse.maxCoeff() <= share) {  // whatever the direction
      return;
    }
    for (int j = 0; j < 3; ++j) {
      const double part = std::abs(value * direction[j]) * limit_inverse[j];
      if (part > share) {
        share = part;
        cause = {kind, static_cast<std::int8_t>(j)};
      }
    }
  }
};

class BlendRunner {
 public:
  BlendRunner(const BlendShape& shape, const SpeedBound& ceiling, const BlendLimits& limits)
      : shape_(shape), ceiling_(ceiling), limits_(limits) {}

  /// Rows (0)-(3) and (5) at a sample; the interval of the jerk already respects row (4).
  Use use_at(const Sample& sample) const {
    const BlendShape::Point p = shape_.at(sample.u);
    const double v = p.sigma * sample.du;
    const double dv = p.dsigma * sample.du * sample.du + p.sigma * sample.ddu;
    const auto jerk_inverse = [&] {
      return p.tangent.cwiseAbs().cwiseProduct(limits_.inverse.tangential_jerk).maxCoeff();
    };
    Use use;
    use.share = (v + (dv > 0 ? dv * dv / 2 * jerk_inverse() : 0)) / ceiling_.value;
    use.cause = ceiling_.cause;
    use.add(v, limits_.inverse.velocity, p.tangent, CauseKind::blend_velocity);
    use.add(dv, limits_.inverse.tangential_acceleration, p.tangent, CauseKind::blend_tangential_acceleration);
    use.add(v * v * p.k, limits_.inverse.radial_acceleration, p.normal, CauseKind::blend_radial_acceleration);
    use.add(3 * v * dv * p.k + v * v * v * p.dk_ds, limits_.inverse.radial_jerk, p.normal,
            CauseKind::blend_radial_jerk);
    return use;
  }

  /// Parametric jerk for the next `period`, and its limiting cause. `p`: the blend at `now`.
  std::pair<double, Cause> choose(const Sample& now, const BlendShape::Point& p, double period) const {
    const AxisBound jerk = axis_share(limits_.tangential_jerk, p.tangent);
    const double v = p.sigma * now.du;
    const double c =
        p.ddsigma * now.du * now.du * now.du + 3 * p.dsigma * now.du * now.ddu - v * v * v * p.k * p.k;
    double low = (-jerk.value - c) / p.sigma;
    double high = (jerk.value - c) / p.sigma;
    const auto use = [&](double x) {
      const Sample next = step(now, x, period);
      return use_at(next.u <= 1 ? next : step(now, x, time_to_end(now, x, period)));
    };

    Candidate broken{high, use(high)};
    if (broken.use.share <= 1) {
      return {high, {CauseKind::blend_tangential_jerk, jerk.axis}};
    }
    Candidate kept{low, use(low)};
    if (kept.use.share > 1) {
      const double least = least_excess(kept, broken, use);
      kept = least == low ? kept : Candidate{least, use(least)};
      if (kept.use.share > 1) {
        return {kept.jerk, kept.use.cause};
      }
    }
    return largest_kept(kept, broken, use);
  }

 private:
  struct Candidate {
    double jerk;
    Use use;
  };

  /// Place between `kept` and `broken` where the share passes 1, to 2^-24 of their distance or 2^-20 of the
  /// limit from below: regula falsi (Illinois), in steps that stay away from both ends by at least this part
  /// of the distance.
  template <typename F>
  static std::pair<double, Cause> largest_kept(Candidate kept, Candidate broken, const F& use) {
    constexpr double rounding = 0x1p-20;
    const double min_step = 0x1p-24 * (broken.jerk - kept.jerk);
    double below = 1 - kept.use.share;
    double above = broken.use.share - 1;
    int side = 0;
    for (int i = 0;
         i < 60 && broken.jerk - kept.jerk > min_step * (1 + 1e-6) && kept.use.share < 1 - rounding; ++i) {
      const double width = broken.jerk - kept.jerk;
      const double step = i < 30 ? width * below / (below + above) : width / 2;
      const double jerk = kept.jerk + std::clamp(step, min_step, width - min_step);
      const Use there = use(jerk);
      if (there.share <= 1) {
        above = side == 1 ? above / 2 : above;
        below = 1 - there.share;
        kept = {jerk, there};
        side = 1;
      } else {
        below = side == -1 ? below / 2 : below;
        above = there.share - 1;
        broken = {jerk, there};
        side = -1;
      }
    }
    return {kept.jerk, broken.use.cause};
  }

  /// Minimum of the share, to 2^-24 of it. Within one sample it is convex in the jerk, and usually the larger
  /// of two almost straight rows. So the next place is where the tangents at both ends meet; often the share
  /// rises from `low` or falls to `high`, and that is the minimum.
  template <typename F>
  static double least_excess(const Candidate& low, const Candidate& high, const F& use) {
    constexpr int steps = 16;
    constexpr double rounding = 0x1p-24;
    const double probe = 1e-6 * (high.jerk - low.jerk);
    struct Tangent {
      double jerk, share, slope;
      double at(double there) const { return share + slope * (there - jerk); }
    };
    const auto tangent_at = [&](double jerk, double share, double probed) {
      return Tangent{jerk, share, (use(jerk + probed).share - share) / probed};
    };
    Tangent left = tangent_at(low.jerk, low.use.share, probe);
    if (left.slope >= 0) {
      return low.jerk;
    }
    Tangent right = tangent_at(high.jerk, high.use.share, -probe);
    if (right.slope <= 0) {
      return high.jerk;
    }
    double best = low.use.share < high.use.share ? low.jerk : high.jerk;
    double least = std::min(low.use.share, high.use.share);
    for (int i = 0; i < steps && right.jerk - left.jerk > 2 * probe; ++i) {
      const double meet = (right.at(0) - left.at(0)) / (left.slope - right.slope);
      const double jerk = std::clamp(meet, left.jerk + probe, right.jerk - probe);
      const double share = use(jerk).share;
      if (share < least) {
        least = share;
        best = jerk;
      }
      if (share - left.at(meet) <= rounding * share) {
        break;
      }
      const Tangent there = tangent_at(jerk, share, probe);
      (there.slope < 0 ? left : right) = there;
    }
    return best;
  }

  const BlendShape& shape_;
  const SpeedBound& ceiling_;
  const BlendLimits& limits_;
};

}  // namespace

BlendLimits::BlendLimits(const AxisVectors& axes, double radial_acceleration_share, double radial_jerk_share)
    : BlendRows{axes.velocity, (1 - radial_acceleration_share) * axes.acceleration,
                radial_acceleration_share * axes.acceleration, (1 - radial_jerk_share) * axes.blend_jerk,
                radial_jerk_share * axes.blend_jerk},
      inverse{velocity.cwiseInverse(), tangential_acceleration.cwiseInverse(),
              radial_acceleration.cwiseInverse(), tangential_jerk.cwiseInverse(), radial_jerk.cwiseInverse()},
      least_velocity(velocity.minCoeff()),
      least_radial_acceleration(radial_acceleration.minCoeff()) {}

SpeedBound entry_speed_limit(const BlendShape::Point& entry, const SpeedBound& feed,
                             const BlendLimits& limits) {
  SpeedBound bound = feed;
  const AxisBound velocity = axis_share(limits.velocity, entry.tangent);
  const AxisBound radial = axis_share(limits.radial_acceleration, entry.k * entry.normal);
  const AxisBound jerk = axis_share(limits.radial_jerk, entry.dk_ds * entry.normal);
  bound.lower(velocity.value, {CauseKind::blend_velocity, velocity.axis});
  if (radial.value < bound.value * bound.value) {
    bound.lower(std::sqrt(radial.value), {CauseKind::blend_radial_acceleration, radial.axis});
  }
  if (jerk.value < bound.value * bound.value * bound.value) {
    bound.lower(std::cbrt(jerk.value), {CauseKind::blend_radial_jerk, jerk.axis});
  }
  return bound;
}

namespace {

/// Lowers the speed at u = 0 until rows (0)-(3) are kept at `p`, whether the blend is passed at constant
/// speed or at constant du/dt; `sigma`: at u = 0.
void lower_to_steady_rows(SpeedBound& speed, double feed, const BlendShape::Point& p, double sigma,
                          const BlendLimits& limits) {
  const double share = p.sigma / sigma;  // of the speed at u = 0, at constant du/dt
  const double growth = std::max(1.0, share);
  const double v = share * speed.value;
  Use use;
  use.share = growth * speed.value / feed;
  use.add(growth * speed.value, limits.inverse.velocity, p.tangent, CauseKind::blend_velocity);
  use.add(v * v * p.k, limits.inverse.radial_acceleration, p.normal, CauseKind::blend_radial_acceleration);
  if (use.share <= 1) {
    return;
  }
  const AxisBound velocity = axis_share(limits.velocity, growth * p.tangent);
  const AxisBound across = axis_share(limits.radial_acceleration, share * share * p.k * p.normal);
  speed.lower(feed / growth, speed.cause);
  speed.lower(velocity.value, {CauseKind::blend_velocity, velocity.axis});
  speed.lower(std::sqrt(across.value), {CauseKind::blend_radial_acceleration, across.axis});
}

/// True if rows (0), (1) and (3) are kept for every direction on the whole blend, so that single axes need no
/// check: checks `intervals` places from u = 0 to the middle; the other half is the mirror image.
bool keeps_steady_rows_whatever_axis(const BlendShape& shape, double sigma, double speed, double feed,
                                     const BlendLimits& limits, int intervals) {
  const double fastest = std::min(feed, limits.least_velocity);
  for (int i = 0; i <= intervals / 2; ++i) {
    const BlendShape::Bend bend = shape.bend_at(static_cast<double>(i) / intervals);
    const double share = bend.sigma / sigma;
    const double v = share * speed;
    if (std::max(1.0, share) * speed > fastest || v * v * bend.k > limits.least_radial_acceleration) {
      return false;
    }
  }
  return true;
}

}  // namespace

MotionLimits blend_motion_limits(const BlendShape& shape, const SpeedBound& speed, double feed,
                                 const BlendLimits& limits) {
  constexpr int intervals = 8;
  const Vec3 tangent = shape.largest_tangent();
  MotionLimits least{speed, axis_share(limits.tangential_acceleration, tangent),
                     axis_share(limits.tangential_jerk, tangent)};
  const double sigma = shape.bend_at(0).sigma;
  if (keeps_steady_rows_whatever_axis(shape, sigma, speed.value, feed, limits, intervals)) {
    return least;
  }
  for (int i = 0; i <= intervals; ++i) {
    lower_to_steady_rows(least.speed, feed, shape.at(static_cast<double>(i) / intervals), sigma, limits);
  }
  return least;
}

BlendMotion run_blend(const BlendShape& shape, double speed, const SpeedBound& ceiling,
                      const BlendLimits& limits, double period, double fastest) {
  constexpr std::size_t max_samples = 5000;
  const BlendRunner runner(shape, ceiling, limits);
  const BlendShape::Point entry = shape.at(0);
  const double du = speed / entry.sigma;
  Sample now{0, du, -entry.dsigma * du * du / entry.sigma};

  BlendMotion motion;
  const auto look_at = [&](const Sample& sample, const BlendShape::Point& p) {
    const double v = p.sigma * sample.du;
    motion.peak_speed = std::max(motion.peak_speed, v);
    for (int j = 0; j < 3; ++j) {
      motion.peak_axis_use =
          std::max(motion.peak_axis_use, v * std::abs(p.tangent[j]) * limits.inverse.velocity[j]);
    }
  };
  while (motion.steps.size() < max_samples && now.du > 1e-3 * du) {
    const BlendShape::Point here = shape.at(now.u);
    const auto [jerk, cause] = runner.choose(now, here, period);
    const Sample next = step(now, jerk, period);
    const double duration = next.u < 1 ? period : time_to_end(now, jerk, period);
    look_at(now, here);
    const Sample half_way = step(now, jerk, duration / 2);
    look_at(half_way, shape.at(half_way.u));
    if (motion.peak_speed > fastest * sampled_slack || motion.peak_axis_use > sampled_slack) {
      break;
    }
    if (next.u < 1) {
      motion.steps.push_back({period, now.u, now.du, now.ddu, jerk, cause});
      now = next;
      continue;
    }
    motion.steps.push_back({duration, now.u, now.du, now.ddu, jerk, cause});
    const Sample end = step(now, jerk, duration);
    const BlendShape::Point p = shape.at(1);
    motion.exit_speed = p.sigma * end.du;
    motion.peak_speed = std::max(motion.peak_speed, motion.exit_speed);
    motion.exit_acceleration = p.dsigma * end.du * end.du + p.sigma * end.ddu;
    motion.complete = end.du > 0 && motion.peak_speed <= fastest * sampled_slack;
    break;
  }
  return motion;
}

SpeedBound steady_speed_limit(const BlendShape& shape, const SpeedBound& feed, const BlendLimits& limits) {
  constexpr int intervals = 200;
  SpeedBound rate{std::numeric_limits<double>::infinity(), feed.cause};
  for (int i = 0; i <= intervals; ++i) {
    const BlendShape::Point p = shape.at(static_cast<double>(i) / intervals);
    const double s = p.sigma;
    const AxisBound velocity = axis_share(limits.velocity, s * p.tangent);
    const AxisBound along = axis_share(limits.tangential_acceleration, p.dsigma * p.tangent);
    const AxisBound across = axis_share(limits.radial_acceleration, s * s * p.k * p.normal);
    const AxisBound jerk_along =
        axis_share(limits.tangential_jerk, (p.ddsigma - s * s * s * p.k * p.k) * p.tangent);
    const AxisBound jerk_across =
        axis_share(limits.radial_jerk, (3 * s * p.dsigma * p.k + s * s * s * p.dk_ds) * p.normal);
    const auto lower = [&](const AxisBound& bound, int order, CauseKind kind) {
      if (bound.value <
          rate.value * rate.value *
              (order == 2 ? 1 : rate.value)) {  // most are not the smallest so far and need no root
        rate.lower(order == 2 ? std::sqrt(bound.value) : std::cbrt(bound.value), {kind, bound.axis});
      }
    };
    rate.lower(feed.value / s, feed.cause);
    rate.lower(velocity.value, {CauseKind::blend_velocity, velocity.axis});
    lower(along, 2, CauseKind::blend_tangential_acceleration);
    lower(across, 2, CauseKind::blend_radial_acceleration);
    lower(jerk_along, 3, CauseKind::blend_tangential_jerk);
    lower(jerk_across, 3, CauseKind::blend_radial_jerk);
  }
  return {rate.value * shape.at(0).sigma, rate.cause};
}

namespace {

/// Demand on the axes at one place of a blend run by its parameter, and their limits there.
struct ParameterPlace {
  double g;        ///< |S'(u)| / |S'(0)|
  double g_x;      ///< |dg/dx|
  double turning;  ///< v^2 k / w^2
  double along;    ///< |v'' - v^3 k^2| / w^3 where w' = w'' = 0
  double across;   ///< |3 v v' k + v^3 dk/ds| / w^3, likewise
  AxisBound acceleration, jerk, across_jerk;
};

ParameterPlace parameter_place(const BlendShape::Point& p, double sigma, const BlendLimits& limits) {
  const double g = p.sigma / sigma;
  const double g_x = p.dsigma / (sigma * sigma);
  const double g_xx = p.ddsigma / (sigma * sigma * sigma);
  return {g,
          std::abs(g_x),
          g * g * p.k,
          std::abs(g_xx - g * g * g * p.k * p.k),
          std::abs(3 * g * g_x * p.k + g * g * g * p.dk_ds),
          axis_share(limits.tangential_acceleration, p.tangent),
          axis_share(limits.tangential_jerk, p.tangent),
          axis_share(limits.radial_jerk, p.normal)};
}

void lower(AxisBound& bound, double value, const AxisBound& by) {
  if (value < bound.value) {
    bound = {value, by.axis};
  }
}

}  // namespace

BlendRamps parameter_ramps(const BlendShape& shape, const BlendLimits& limits) {
  constexpr int intervals = 64;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::array<ParameterPlace, intervals + 1> places;
  const double sigma = shape.at(0).sigma;
  double velocity = infinite;         // row (1)
  double turning_squared = infinite;  // row (3)
  double ramping_squared = infinite;  // row (2)
  double ramping_cubed = infinite;    // rows (4) and (5)
  for (std::size_t i = 0; i < places.size(); ++i) {
    const BlendShape::Point p = shape.at(static_cast<double>(i) / intervals);
    places[i] = parameter_place(p, sigma, limits);
    const ParameterPlace& at = places[i];
    velocity = std::min(velocity, axis_share(limits.velocity, at.g * p.tangent).value);
    turning_squared =
        std::min(turning_squared, axis_share(limits.radial_acceleration, at.turning * p.normal).value);
    ramping_squared = std::min(ramping_squared, at.acceleration.value / at.g_x);
    ramping_cubed = std::min({ramping_cubed, at.jerk.value / at.along, at.across_jerk.value / at.across});
  }
  const double turning = std::min(velocity, std::sqrt(turning_squared));
  const double ramping = std::min(std::sqrt(ramping_squared), std::cbrt(ramping_cubed));
  BlendRamps ramps;
  for (std::size_t step = 0; step < ramps.size(); ++step) {
    const double w = blend_ramp_speed(step, turning, ramping);
    AxisBound acceleration{infinite, -1};
    AxisBound jerk{infinite, -1};
    for (const ParameterPlace& at : places) {
      lower(acceleration, (at.acceleration.value - at.g_x * w * w) / at.g, at.acceleration);
      lower(acceleration, (at.across_jerk.value - at.across * w * w * w) / (3 * at.turning * w),
            at.across_jerk);
      // Half of the rest of row (4) is for 3 g_x w w', the other half for g w''.
      lower(acceleration, (at.jerk.value - at.along * w * w * w) / (6 * at.g_x * w), at.jerk);
    }
    for (const ParameterPlace& at : places) {
      const double rest = at.jerk.value - at.along * w * w * w - 3 * at.g_x * w * acceleration.value;
      lower(jerk, rest / at.g, at.jerk);
    }
    ramps[step] = {w, acceleration, jerk};
  }
  return ramps;
}

bool keeps_rows_at(const BlendShape& shape, double speed, const BlendLimits& limits) {
  constexpr int intervals = 16;
  const double v2 = speed * speed;
  for (int i = 0; i <= intervals; ++i) {
    const BlendShape::Point p = shape.at(static_cast<double>(i) / intervals);
    Use use;
    use.add(speed, limits.inverse.velocity, p.tangent, CauseKind::blend_velocity);
    use.add(v2 * p.k, limits.inverse.radial_acceleration, p.normal, CauseKind::blend_radial_acceleration);
    use.add(v2 * speed * p.k * p.k, limits.inverse.tangential_jerk, p.tangent,
            CauseKind::blend_tangential_jerk);
    use.add(v2 * speed * p.dk_ds, limits.inverse.radial_jerk, p.normal, CauseKind::blend_radial_jerk);
    if (use.share > 1) {
      return false;
    }
  }
  return true;
}

}  // namespace feedscope
