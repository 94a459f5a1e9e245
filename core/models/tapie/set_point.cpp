#include "core/models/tapie/set_point.h"

#include <array>
#include <cmath>
#include <optional>

#include "core/base/units.h"

namespace feedscope {
namespace {

/// Demand of constant speed on the axes along an arc, per v^3 and as a share of each axis' jerk:
/// |x_j cos a + y_j sin a|. Every share repeats after half a turn.
class JerkShares {
 public:
  JerkShares(const Arc& arc, const Vec3& jerk) : sweep_(arc.sweep) {
    const double scale = arc.radius / std::pow(arc.length_per_radian(), 3);
    x_ = scale * arc.y.cwiseQuotient(jerk);
    y_ = -scale * arc.x.cwiseQuotient(jerk);
  }

  AxisBound largest(double a) const {
    AxisBound bound;
    for (int j = 0; j < 3; ++j) {
      const double share = std::abs(x_[j] * std::cos(a) + y_[j] * std::sin(a));
      if (share > bound.value) {
        bound = {share, static_cast<std::int8_t>(j)};
      }
    }
    return bound;
  }

  /// First angle at which the largest share equals `share`.
  std::optional<double> first_equal(double share) const {
    constexpr double rounding = 1e-9;
    std::optional<double> first;
    for (int j = 0; j < 3; ++j) {
      const double crest = std::hypot(x_[j], y_[j]);
      if (crest < share) {
        continue;
      }
      const double middle = std::atan2(y_[j], x_[j]);
      const double half_width = std::acos(share / crest);
      for (const double place : {middle - half_width, middle + half_width}) {
        const double a = in_half_turn(place);
        if (a <= sweep_ && (!first || a < *first) && largest(a).value <= share * (1 + rounding)) {
          first = a;
        }
      }
    }
    return first;
  }

  /// Angle at which the largest share is least: an end of the arc, or where two axes have equal shares or
  /// none.
  double least() const {
    double best = 0;
    double least = largest(0).value;
    const auto consider = [&](double a) {
      if (a <= sweep_ && largest(a).value < least) {
        best = a;
        least = largest(a).value;
      }
    };
    consider(sweep_);
    constexpr std::array<std::array<int, 2>, 3> pairs{{{0, 1}, {0, 2}, {1, 2}}};
    for (const auto& [i, j] : pairs) {
      for (const double sign : {1.0, -1.0}) {
        consider(in_half_turn(std::atan2(-(x_[i] - sign * x_[j]), y_[i] - sign * y_[j])));
      }
    }
    return best;
  }

 private:
  static double in_half_turn(double a) { return a - units::pi * std::floor(a / units::pi); }

  double sweep_;
  Vec3 x_;
  Vec3 y_;
};

}  // namespace

SteadyPlace steady_place(const Arc& arc, const AxisVectors& axes, double control_jerk) {
  const JerkShares shares(arc, axes.jerk);
  const double k = arc.curvature();
  SteadyPlace place;
  place.control_jerk = std::cbrt(control_jerk / (k * k));
  const std::optional<double> equal = shares.first_equal(k * k / control_jerk);
  place.angle = equal ? *equal : shares.least();

  const AxisBound share = shares.largest(place.angle);
  place.jerk = {std::cbrt(1 / share.value), share.axis};
  const CurvePoint at = arc.at(place.angle * arc.length_per_radian());
  const AxisBound radial = axis_share(axes.acceleration, at.d2);
  place.acceleration = {std::sqrt(radial.value), radial.axis};
  place.velocity = axis_share(axes.velocity, at.d1);
  return place;
}

MotionLimits SetPointRule::limits(const Toolpath& toolpath, std::size_t i, const TurnPart* part) const {
  const Segment& segment = toolpath.segments[i];
  MotionLimits limits = segment_limits(toolpath, i, axes, part);
  if (segment.kind == SegmentKind::arc) {
    const SteadyPlace place = steady_place(toolpath.arc_of(segment), axes, control_jerk);
    const AxisBound drive = axis_speed(toolpath, i, axes.velocity);
    SpeedBound speed = feed_ceiling(toolpath, i, axes.velocity);
    speed.lower(place.control_jerk, {CauseKind::curvilinear_jerk});
    speed.lower(place.jerk.value, {CauseKind::radial_jerk, place.jerk.axis});
    speed.lower(place.acceleration.value, {CauseKind::radial_acceleration, place.acceleration.axis});
    speed.lower(place.velocity.value, {CauseKind::axis_velocity, place.velocity.axis});
    speed.lower(drive.value, {CauseKind::axis_velocity, drive.axis});
    limits.speed = speed;
  }
  limits.speed.lower(segment.length / period, {CauseKind::interpolation_period});
  return limits;
}

}  // namespace feedscope
