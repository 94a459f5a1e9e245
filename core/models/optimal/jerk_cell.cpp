#include "core/models/optimal/jerk_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope {
namespace {

using Eigen::Vector4d;

/// Speed, acceleration and jerk at a place of a cell.
struct PlaceMotion {
  double v;
  double a;
  double j;
};

/// On short cells with many places the speed hardly changes: it is linear there.
PlaceMotion motion_at(const CellMotion& m, double share, bool second) {
  const double j = second ? m.j2 : m.j1;
  if (share == 0.5) {
    return {m.v_middle, m.a_middle, j};
  }
  return {m.v0 + share * (m.v1 - m.v0), m.a0 + share * (m.a1 - m.a0), j};
}

bool is_second(double share) {
  return share > 0.5;
}

/// Speeds in the middle of both halves.
double first_quarter(const CellMotion& m) {
  return m.v0 + (m.v1 - m.v0) / 8 + (5 * m.a0 - m.a1) * m.time / 32;
}
double last_quarter(const CellMotion& m) {
  return m.v1 - (m.v1 - m.v0) / 8 + (m.a0 - 5 * m.a1) * m.time / 32;
}

/// Calls f(p, order) for every limit at a place, of the first to the third derivative; the jerks of both
/// halves limit the middle.
template <typename F>
void for_each_load(const CellMotion& m, const CellPlace& place, F f) {
  const PlaceMotion at = motion_at(m, place.share, is_second(place.share));
  f(at.v / place.limits.ceiling, 1);
  for (int k = 0; k < place.limits.count; ++k) {
    f(place.limits.acceleration(k, at.v, at.a), 2);
    f(place.limits.jerk(k, at.v, at.a, at.j), 3);
    if (place.share == 0.5) {
      f(place.limits.jerk(k, at.v, at.a, m.j2), 3);
    }
  }
  if (place.share == 0.5) {
    f(first_quarter(m) / place.limits.ceiling, 1);
    f(last_quarter(m) / place.limits.ceiling, 1);
  }
}

/// Slopes of tau, the jerks and the middle by (v0, a0, v1, a1).
struct MotionSlopes {
  Vector4d time;
  Vector4d j1;
  Vector4d j2;
  Vector4d v_middle;
  Vector4d a_middle;
  Vector4d first_quarter;
  Vector4d last_quarter;

  explicit MotionSlopes(const CellMotion& m) {
    const double t = m.time;
    time = Vector4d(-6 * t, -t * t, -6 * t, t * t) / m.root;
    const double dv = m.v1 - m.v0;
    const double t2 = t * t;
    j1 = Vector4d(-4 / t2, -3 / t, 4 / t2, -1 / t) + (-8 * dv / (t2 * t) + (3 * m.a0 + m.a1) / t2) * time;
    j2 = Vector4d(4 / t2, 1 / t, -4 / t2, 3 / t) + (8 * dv / (t2 * t) - (m.a0 + 3 * m.a1) / t2) * time;
    v_middle = Vector4d(0.5, t / 8, 0.5, -t / 8) + (m.a0 - m.a1) / 8 * time;
    first_quarter = Vector4d(0.875, 5 * t / 32, 0.125, -t / 32) + (5 * m.a0 - m.a1) / 32 * time;
    last_quarter = Vector4d(0.125, t / 32, 0.875, -5 * t / 32) + (m.a0 - 5 * m.a1) / 32 * time;
    a_middle = Vector4d(-2 / t, -0.5, 2 / t, -0.5) - 2 * dv / t2 * time;
  }
};

/// From slopes by speed v, number `index`, to slopes by x = v^2; `time_slope`: by v, of the time alone.
void to_squares(CellCost& cost, int index, double v, double time_slope) {
  const double factor = v > 0 ? 1 / (2 * v) : 0;  // at rest v is given
  cost.slope[index] *= factor;
  cost.curvature.row(index) *= factor;
  cost.curvature.col(index) *= factor;
  cost.curvature(index, index) -= 2 * time_slope * factor * factor * factor;
}

}  // namespace

CellMotion CellMotion::through(double length, double v0, double a0, double v1, double a1) {
  CellMotion m;
  const double sum = 6 * (v0 + v1);
  const double discriminant = sum * sum - 48 * (a1 - a0) * length;
  if (!(discriminant > 0)) {
    return m;
  }
  m.root = std::sqrt(discriminant);
  m.time = 24 * length / (sum + m.root);
  m.v0 = v0;
  m.a0 = a0;
  m.v1 = v1;
  m.a1 = a1;
  const double turn = 4 * (v1 - v0) / (m.time * m.time);
  m.j1 = turn - (3 * a0 + a1) / m.time;
  m.j2 = (a0 + 3 * a1) / m.time - turn;
  m.v_middle = (v0 + v1) / 2 + (a0 - a1) * m.time / 8;
  m.a_middle = 2 * (v1 - v0) / m.time - (a0 + a1) / 2;
  return m;
}

PlaceLimits::PlaceLimits(const PathPoint& point, bool straight, double speed, const Vec3& acceleration,
                         const Vec3& jerk)
    : ceiling(speed) {
  if (straight) {
    const AxisBound a = axis_share(acceleration, point.t);
    const AxisBound j = axis_share(jerk, point.t);
    count = 1;
    tangential_over_acceleration[0] = 1 / a.value;
    tangential_over_jerk[0] = 1 / j.value;
    curvature_over_acceleration[0] = curvature_over_jerk[0] = curvature_rate_over_jerk[0] = 0;
    axis[0] = a.axis;
    return;
  }
  for (int j = 0; j < 3; ++j) {
    if (point.t[j] == 0 && point.c[j] == 0 && point.d[j] == 0) {
      continue;
    }
    const auto k = static_cast<std::size_t>(count++);
    tangential_over_acceleration[k] = point.t[j] / acceleration[j];
    curvature_over_acceleration[k] = point.c[j] / acceleration[j];
    tangential_over_jerk[k] = point.t[j] / jerk[j];
    curvature_over_jerk[k] = 3 * point.c[j] / jerk[j];
    curvature_rate_over_jerk[k] = point.d[j] / jerk[j];
    axis[k] = static_cast<std::int8_t>(j);
  }
}

double PlaceLimits::acceleration(int index, double v, double a) const {
  const auto k = static_cast<std::size_t>(index);
  return tangential_over_acceleration[k] * a + curvature_over_acceleration[k] * v * v;
}

double PlaceLimits::jerk(int index, double v, double a, double j) const {
  const auto k = static_cast<std::size_t>(index);
  return tangential_over_jerk[k] * j + v * (curvature_over_jerk[k] * a + curvature_rate_over_jerk[k] * v * v);
}

double PlaceLimits::jerk_along() const {
  double most = infinite;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    most = std::min(most, 1 / std::abs(tangential_over_jerk[k]));
  }
  return most;
}

double cell_excess(const CellMotion& motion, const CellPlace* first, const CellPlace* last) {
  double excess = 0;
  for (const CellPlace* place = first; place != last; ++place) {
    for_each_load(motion, *place, [&](double p, int order) {
      const double load = std::abs(p);
      excess = std::max(excess, order == 1 ? load : order == 2 ? std::sqrt(load) : std::cbrt(load));
    });
  }
  return excess;
}

double cell_value(const CellMotion& motion, const CellPlace* first, const CellPlace* last, double mu) {
  if (!(motion.time > 0) || motion.v_middle <= 0 || first_quarter(motion) <= 0 || last_quarter(motion) <= 0) {
    return infinite;
  }
  double product = 1;
  double logs = 0;
  for (const CellPlace* place = first; place != last; ++place) {
    for_each_load(motion, *place, [&](double p, int /*order*/) {
      const double left = 1 - p * p;
      product *= left > 0 ? left : 0;
      if (product < 1e-200) {
        logs += product > 0 ? -std::log(product) : infinite;
        product = 1;
      }
    });
  }
  return motion.time + mu * (logs - std::log(product));
}

CellCost cell_cost(const CellMotion& m, double length, const CellPlace* first, const CellPlace* last,
                   double mu) {
  const MotionSlopes slopes(m);
  CellCost cost;
  cost.slope = slopes.time;
  const double sum = m.v0 + m.v1;
  const double bend = 4 * length / (sum * sum * sum);
  cost.curvature(0, 0) = cost.curvature(0, 2) = cost.curvature(2, 0) = cost.curvature(2, 2) = bend;
  const auto add = [&](double p, const Vector4d& slope) {
    const double left = 1 - p * p;
    cost.slope += mu * 2 * p / left * slope;
    cost.curvature += mu * 2 * (1 + p * p) / (left * left) * slope * slope.transpose();
  };
  for (const CellPlace* place = first; place != last; ++place) {
    const bool middle = place->share == 0.5;
    const bool second = is_second(place->share);
    const PlaceMotion at = motion_at(m, place->share, second);
    const double w = place->share;
    const Vector4d v = middle ? slopes.v_middle : Vector4d(1 - w, 0, w, 0);
    const Vector4d a = middle ? slopes.a_middle : Vector4d(0, 1 - w, 0, w);
    const PlaceLimits& limits = place->limits;
    add(at.v / limits.ceiling, v / limits.ceiling);
    if (middle) {
      add(first_quarter(m) / limits.ceiling, slopes.first_quarter / limits.ceiling);
      add(last_quarter(m) / limits.ceiling, slopes.last_quarter / limits.ceiling);
    }
    for (int index = 0; index < limits.count; ++index) {
      const auto k = static_cast<std::size_t>(index);
      add(limits.acceleration(index, at.v, at.a),
          limits.tangential_over_acceleration[k] * a + 2 * limits.curvature_over_acceleration[k] * at.v * v);
      const Vector4d turning = limits.curvature_over_jerk[k] * (at.v * a + at.a * v) +
                               3 * limits.curvature_rate_over_jerk[k] * at.v * at.v * v;
      add(limits.jerk(index, at.v, at.a, at.j),
          limits.tangential_over_jerk[k] * (second ? slopes.j2 : slopes.j1) + turning);
      if (middle) {
        add(limits.jerk(index, at.v, at.a, m.j2), limits.tangential_over_jerk[k] * slopes.j2 + turning);
      }
    }
  }
  to_squares(cost, 0, m.v0, slopes.time[0]);
  to_squares(cost, 2, m.v1, slopes.time[2]);
  return cost;
}

}  // namespace feedscope
