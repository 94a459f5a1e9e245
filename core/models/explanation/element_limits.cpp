#include "core/models/explanation/element_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/base/units.h"
#include "core/blend/path_rules.h"
#include "core/machine/settings.h"

namespace feedscope {
namespace {

/// Smallest limits of ramps over elements [.., last).
struct LeastRamp {
  double acceleration = std::numeric_limits<double>::infinity();
  double jerk = std::numeric_limits<double>::infinity();
};

}  // namespace

ElementLimits::ElementLimits(const SimulatedMotion& motion)
    : motion_(motion), path_(motion.trajectory.path()), axes_(motion.machine) {}

double ElementLimits::shortest_block(std::uint32_t element) const {
  const SpeedBound ceiling = path_.kind(element) == ElementKind::curve
                                 ? programmed_speed_of_span(path_, element, axes_.velocity)
                                 : element_ceiling(path_, element, axes_.velocity);
  return ceiling.value * path_.programmed()->block_time;
}

const Arc* ElementLimits::programmed_arc(std::uint32_t element) const {
  const Toolpath& path = *path_.programmed();
  const Segment& segment = path.segments[path_.segment(element)];
  const ElementKind kind = path_.kind(element);
  const bool runs_on_it = kind == ElementKind::arc || kind == ElementKind::filtered;
  return segment.kind == SegmentKind::arc && runs_on_it ? &path.arc_of(segment) : nullptr;
}

bool ElementLimits::accelerates_by_jumps(std::uint32_t element) const {
  const PathRules rules = PathRules::exact_corners(path_.base());
  const std::size_t first = block(element);
  return rules.acceleration_jumps(first) &&
         (!path_.in_corner(element) || rules.acceleration_jumps(first + 1));
}

Formula ElementLimits::min_share(FormulaId id, Symbol limit, const Vec3& limits, const Vec3& parts) const {
  const AxisBound bound = axis_share(limits, parts);
  if (bound.axis < 0) {
    return {};
  }
  return {id,
          {{limit, bound.axis, limits[bound.axis]},
           {Symbol::tangent_part, bound.axis, std::abs(parts[bound.axis])}}};
}

Formula ElementLimits::blend_rest(FormulaId id, Symbol share, Symbol limit, std::uint32_t element) const {
  const bool is_jerk = limit == Symbol::blend_jerk;
  const Vec3& limits = is_jerk ? axes_.blend_jerk : axes_.acceleration;
  const double radial = setting(is_jerk ? "radial_jerk_share" : "radial_acceleration_share");
  Vec3 parts;
  if (path_.kind(element) == ElementKind::blend) {
    parts = blend_shape(element).largest_tangent();
  } else {
    const Arc arc = path_.curve(element).arc;
    const ArcExtremes extremes(arc);
    constexpr double moves = 1e-9;
    for (int j = 0; j < 3; ++j) {
      parts[j] = extremes.tangent[j] > moves ? 1 : 0;
    }
  }
  const AxisBound bound = axis_share(limits, parts);
  return {id,
          {{share, -1, radial},
           {limit, bound.axis, limits[bound.axis]},
           {Symbol::tangent_part, bound.axis, parts[bound.axis]}}};
}

Formula ElementLimits::path_acceleration(std::uint32_t element) const {
  constexpr auto id = FormulaId::path_acceleration;
  if (path_.in_corner(element) && shares_corners()) {
    return blend_rest(FormulaId::shared_acceleration, Symbol::acceleration_share, Symbol::axis_acceleration,
                      element);
  }
  if (path_.kind(element) == ElementKind::curve) {
    return curve_ramp(false, element);
  }
  const ElementCurve curve = path_.curve(element);
  const Vec3 parts = curve.is_arc() ? ArcExtremes(curve.arc).tangent : curve.direction;
  return min_share(id, Symbol::axis_acceleration, axes_.acceleration, parts);
}

Formula ElementLimits::path_jerk(std::uint32_t element) const {
  Formula steady;
  if (path_.in_corner(element) && shares_corners()) {
    steady = blend_rest(FormulaId::shared_jerk, Symbol::jerk_share, Symbol::blend_jerk, element);
  } else if (path_.kind(element) == ElementKind::curve) {
    steady = curve_ramp(true, element);
  } else {
    const ElementCurve curve = path_.curve(element);
    const Vec3 parts = curve.is_arc() ? ArcExtremes(curve.arc).tangent : curve.direction;
    steady = min_share(FormulaId::path_jerk, Symbol::axis_jerk, axes_.jerk, parts);
  }
  if (!accelerates_by_jumps(element)) {
    return steady;
  }
  const Formula acceleration = path_acceleration(element);
  const Formula jump{FormulaId::acceleration_jump,
                     {{Symbol::path_acceleration, -1, acceleration.value()},
                      {Symbol::period, -1, setting("interpolation_period_s")}}};
  return jump.value() > steady.value() ? jump : steady;
}

BlendShape ElementLimits::blend_shape(std::uint32_t element) const {
  const CubicBlend blend = path_.curve(element).blend;
  const Vec3 in = blend.corner - blend.start;
  return {in.normalized(), (blend.end - blend.corner).normalized(), in.norm(), blend.alpha};
}

ElementLimits::ArcParts ElementLimits::parts_of(const Arc& arc) const {
  const ArcExtremes extremes(arc);
  return {extremes.tangent, extremes.tangent, extremes.normal};
}

Formula ElementLimits::arc_speed(Cause cause, const Arc& arc) const {
  const double k = arc.curvature();
  const Quantity radius{Symbol::radius, -1, 1 / k};
  if (cause.kind == CauseKind::curvilinear_jerk) {
    return {FormulaId::curvilinear_jerk,
            {{Symbol::curvilinear_jerk, -1, units::from_m(setting("curvilinear_jerk_m_s3"))},
             {Symbol::tangential_share, -1, setting("tangential_share")},
             radius}};
  }
  if (cause.axis < 0) {
    return {};
  }
  const ArcParts parts = parts_of(arc);
  switch (cause.kind) {
    case CauseKind::axis_velocity:
    case CauseKind::rapid:
      return {FormulaId::axis_velocity,
              {{Symbol::axis_velocity, cause.axis, axes_.velocity[cause.axis]},
               {Symbol::tangent_part, cause.axis, parts.velocity[cause.axis]}}};
    case CauseKind::radial_acceleration:
      return {FormulaId::radial_acceleration,
              {{Symbol::axis_acceleration, cause.axis, axes_.acceleration[cause.axis]},
               radius,
               {Symbol::normal_part, cause.axis, std::abs(parts.normal[cause.axis])}}};
    case CauseKind::radial_jerk:
      return {FormulaId::radial_jerk,
              {{Symbol::axis_jerk, cause.axis, axes_.jerk[cause.axis]},
               radius,
               {Symbol::tangent_part, cause.axis, std::abs(parts.tangent[cause.axis])}}};
    default:
      return {};
  }
}

/// Speed ceiling that `cause` sets for a span of a smooth curve (curve_limits()).
Formula ElementLimits::curve_speed(Cause cause, std::uint32_t element) const {
  const std::int8_t j = cause.axis;
  if (j < 0) {
    return {};
  }
  const SpanExtremes extremes(*path_.curve(element).span);
  switch (cause.kind) {
    case CauseKind::axis_velocity:
      return {
          FormulaId::axis_velocity,
          {{Symbol::axis_velocity, j, axes_.velocity[j]}, {Symbol::tangent_part, j, extremes.tangent[j]}}};
    case CauseKind::radial_acceleration:
      return {FormulaId::curve_acceleration,
              {{Symbol::turning_share, -1, turning_share},
               {Symbol::axis_acceleration, j, axes_.acceleration[j]},
               {Symbol::bend_part, j, extremes.bend[j]}}};
    case CauseKind::radial_jerk:
      return {FormulaId::curve_jerk,
              {{Symbol::turning_share, -1, turning_share},
               {Symbol::axis_jerk, j, axes_.jerk[j]},
               {Symbol::bend_change_part, j, extremes.change[j]}}};
    default:
      return {};
  }
}

/// Share of an axis' acceleration or jerk that the highest speed on a span of a smooth curve leaves for
/// ramps.
Formula ElementLimits::curve_ramp(bool by_jerk, std::uint32_t element) const {
  const SpanExtremes extremes(*path_.curve(element).span);
  const MotionLimits limits =
      curve_limits(extremes, programmed_speed_of_span(path_, element, axes_.velocity), axes_);
  const std::int8_t j = (by_jerk ? limits.jerk : limits.acceleration).axis;
  if (j < 0) {
    return {};
  }
  const Quantity speed{Symbol::ceiling, -1, limits.speed.value};
  const Quantity tangent{Symbol::tangent_part, j, extremes.tangent[j]};
  const Quantity limit = by_jerk ? Quantity{Symbol::axis_jerk, j, axes_.jerk[j]}
                                 : Quantity{Symbol::axis_acceleration, j, axes_.acceleration[j]};
  const Quantity turning = by_jerk ? Quantity{Symbol::bend_change_part, j, extremes.change[j]}
                                   : Quantity{Symbol::bend_part, j, extremes.bend[j]};
  return {by_jerk ? FormulaId::curve_ramp_jerk : FormulaId::curve_ramp_acceleration,
          {limit, speed, turning, tangent}};
}

/// On a circular arc at constant speed: limits along tangent and normal (models/gassara/README.md).
Formula ElementLimits::connecting_arc_speed(Cause cause, double radius) const {
  const Quantity r{Symbol::radius, -1, radius};
  switch (cause.kind) {
    case CauseKind::blend_velocity:
      return {FormulaId::axis_velocity,
              {{Symbol::axis_velocity, cause.axis, axes_.velocity[cause.axis]},
               {Symbol::tangent_part, cause.axis, 1}}};
    case CauseKind::blend_radial_acceleration:
      return {FormulaId::shared_radial_acceleration,
              {{Symbol::acceleration_share, -1, setting("radial_acceleration_share")},
               {Symbol::axis_acceleration, cause.axis, axes_.acceleration[cause.axis]},
               r,
               {Symbol::normal_part, cause.axis, 1}}};
    case CauseKind::blend_radial_jerk:
      return {FormulaId::arc_blend_radial_jerk,
              {{Symbol::jerk_share, -1, setting("radial_jerk_share")},
               {Symbol::blend_jerk, cause.axis, axes_.blend_jerk[cause.axis]},
               r}};
    default:
      return {};
  }
}

/// Formula if the cutting feed of the axis determines the feed of the block (Segment::feed_axis); else none.
std::optional<Formula> ElementLimits::cutting_feed(Cause cause, std::uint32_t element) const {
  const std::size_t first = path_.segment(element);
  for (std::size_t i = first; i <= first + (path_.in_corner(element) ? 1 : 0); ++i) {
    const Segment& segment = path_.programmed()->segments[i];
    if (cause.kind == CauseKind::axis_velocity && cause.axis >= 0 && cause.axis == segment.feed_axis) {
      const double most = units::from_m_min(setting(cutting_feed_key(cause.axis)));
      return Formula{FormulaId::axis_velocity,
                     {{Symbol::axis_velocity, cause.axis, most},
                      {Symbol::tangent_part, cause.axis, most / segment.feed}}};
    }
  }
  return std::nullopt;
}

Formula ElementLimits::speed(Cause cause, std::uint32_t element) const {
  const ElementKind kind = path_.kind(element);
  const Toolpath& programmed = *path_.programmed();
  const std::size_t segment = path_.segment(element);
  if (kind == ElementKind::dwell) {
    return {};
  }
  if (cause.kind == CauseKind::programmed_feed) {
    double feed = programmed.segments[segment].feed;
    if (path_.in_corner(element)) {
      feed = std::min(feed, programmed.segments[segment + 1].feed);
    }
    if (kind == ElementKind::curve) {
      feed = programmed_speed_of_span(path_, element, axes_.velocity).value;
    }
    return {FormulaId::programmed_feed, {{Symbol::feed, -1, feed}}};
  }
  if (cause.kind == CauseKind::block_time) {
    return {FormulaId::block_time,
            {{Symbol::block_length, -1, shortest_block(element)},
             {Symbol::block_time, -1, programmed.block_time}}};
  }
  if (const std::optional<Formula> cutting = cutting_feed(cause, element)) {
    return *cutting;
  }
  if (kind == ElementKind::curve) {
    return curve_speed(cause, element);
  }
  const bool of_velocity = cause.kind == CauseKind::path_velocity || cause.kind == CauseKind::rapid ||
                           cause.kind == CauseKind::axis_velocity;
  if (const auto own = of_velocity ? velocity_of_control(element) : std::nullopt) {
    return *own;
  }
  const ElementCurve curve = path_.curve(element);
  if (cause.kind == CauseKind::interpolation_period) {
    const Segment& whole = path_.base().segments[block(element)];
    const double length = path_.in_corner(element) ? curve.length : whole.length;
    return {FormulaId::interpolation_period,
            {{Symbol::block_length, -1, length}, {Symbol::period, -1, setting("interpolation_period_s")}}};
  }
  if (kind == ElementKind::connecting_arc) {
    const bool own = cause.kind == CauseKind::blend_velocity ||
                     cause.kind == CauseKind::blend_radial_acceleration ||
                     cause.kind == CauseKind::blend_radial_jerk;
    return own && cause.axis >= 0 ? connecting_arc_speed(cause, 1 / curve.arc.curvature())
                                  : arc_speed(cause, curve.arc);
  }
  if (const Arc* arc = programmed_arc(element)) {
    return arc_speed(cause, *arc);
  }
  const bool axis_speed = cause.kind == CauseKind::axis_velocity || cause.kind == CauseKind::rapid;
  if (!axis_speed || cause.axis < 0 || kind == ElementKind::blend) {
    return {};
  }
  // An arc that a control puts into a corner has no one direction.
  const double part =
      curve.is_arc() ? parts_of(curve.arc).velocity[cause.axis] : std::abs(curve.direction[cause.axis]);
  if (!(part > 0)) {
    return {};
  }
  return {FormulaId::axis_velocity,
          {{Symbol::axis_velocity, cause.axis, axes_.velocity[cause.axis]},
           {Symbol::tangent_part, cause.axis, part}}};
}

Formula ElementLimits::blend_speed(Cause cause, const BlendShape& shape, double u, bool steady) const {
  const std::int8_t j = cause.axis;
  if (j < 0) {
    return {};
  }
  const BlendShape::Point p = shape.at(u);
  const Quantity tangent{Symbol::tangent_part, j, std::abs(p.tangent[j])};
  const Quantity normal{Symbol::normal_part, j, std::abs(p.normal[j])};
  const Quantity acceleration{Symbol::axis_acceleration, j, axes_.acceleration[j]};
  const Quantity jerk{Symbol::blend_jerk, j, axes_.blend_jerk[j]};
  const Quantity acceleration_share{Symbol::acceleration_share, -1, setting("radial_acceleration_share")};
  const Quantity jerk_share{Symbol::jerk_share, -1, setting("radial_jerk_share")};
  const double slope = steady ? p.dsigma / (p.sigma * p.sigma) : 0;
  const double bend = (steady ? p.ddsigma / std::pow(p.sigma, 3) : 0) - p.k * p.k;
  switch (cause.kind) {
    case CauseKind::blend_velocity:
      return {FormulaId::axis_velocity, {{Symbol::axis_velocity, j, axes_.velocity[j]}, tangent}};
    case CauseKind::blend_tangential_acceleration:
      return {FormulaId::steady_acceleration,
              {acceleration_share, acceleration, {Symbol::speed_slope, -1, std::abs(slope)}, tangent}};
    case CauseKind::blend_tangential_jerk:
      return {FormulaId::steady_jerk, {jerk_share, jerk, {Symbol::speed_bend, -1, std::abs(bend)}, tangent}};
    case CauseKind::blend_radial_acceleration:
      return {FormulaId::shared_radial_acceleration,
              {acceleration_share, acceleration, {Symbol::radius, -1, 1 / p.k}, normal}};
    case CauseKind::blend_radial_jerk:
      return {FormulaId::shared_radial_jerk,
              {jerk_share, jerk, {Symbol::curvature_slope, -1, std::abs(p.dk_ds + 3 * slope * p.k)}, normal}};
    default:
      return {};
  }
}

Formula ElementLimits::crossing(std::uint32_t element) const {
  if (element == 0 || element >= path_.size()) {
    return {};
  }
  const ElementCurve before = path_.curve(element - 1);
  const ElementCurve after = path_.curve(element);
  const auto bend = [](const ElementCurve& curve, double s) {
    return curve.is_arc() ? curve.arc.at(s).d2 : Vec3(Vec3::Zero());
  };
  const Vec3 step = bend(after, 0) - bend(before, before.length);
  const AxisBound bound = axis_share(axes_.jerk, step);
  if (bound.axis < 0) {
    return {};
  }
  return {FormulaId::curvature_crossing,
          {{Symbol::axis_jerk, bound.axis, axes_.jerk[bound.axis]},
           {Symbol::period, -1, setting("interpolation_period_s")},
           {Symbol::curvature_step, bound.axis, std::abs(step[bound.axis])}}};
}

Formula ElementLimits::horizon(std::uint32_t element) const {
  const auto blocks = static_cast<std::size_t>(setting("lookahead_blocks"));
  LeastRamp least;
  double length = 0;
  std::size_t counted = 0;  // blocks, counted as in Stretch::order
  for (std::uint32_t e = element; e < path_.size() && counted < blocks; ++e) {
    if (path_.kind(e) == ElementKind::dwell) {
      break;
    }
    least.acceleration = std::min(least.acceleration, path_acceleration(e).value());
    least.jerk = std::min(least.jerk, path_jerk(e).value());
    length += path_.length(e);
    if (e + 1 < path_.size()) {
      counted += path_.kind(e + 1) == ElementKind::curve ? 1 : block(e + 1) - block(e);
    }
  }
  const Quantity acceleration{Symbol::path_acceleration, -1, least.acceleration};
  const Quantity jerk{Symbol::path_jerk, -1, least.jerk};
  const Quantity ahead{Symbol::length_ahead, -1, length};
  const Formula by_jerk{FormulaId::horizon_jerk, {jerk, ahead}};
  return by_jerk.value() <= least.acceleration * least.acceleration / least.jerk
             ? by_jerk
             : Formula{FormulaId::horizon_acceleration, {acceleration, jerk, ahead}};
}

Formula ElementLimits::junction(CauseKind kind, std::uint32_t element) const {
  return kind == CauseKind::curvature_crossing  ? crossing(element)
         : kind == CauseKind::lookahead_horizon ? horizon(element)
                                                : Formula();
}

std::optional<HalfTurn> ElementLimits::half_turn(std::uint32_t element) const {
  if (element == 0 || element >= path_.size() || path_.kind(element) == ElementKind::dwell ||
      path_.kind(element - 1) == ElementKind::dwell) {
    return std::nullopt;
  }
  const double cosine = -path_.curve(element - 1).direction.dot(path_.curve(element).direction);
  const HalfTurn half{std::sqrt(std::max(0.0, (1 - cosine) / 2)), std::sqrt(std::max(0.0, (1 + cosine) / 2))};
  return half.cosine > 1e-6 ? std::optional(half) : std::nullopt;
}

std::string_view ElementLimits::source_of(FormulaId id) const {
  switch (id) {
    case FormulaId::none:
      return {};
    case FormulaId::programmed_feed:
      return "program";
    case FormulaId::axis_velocity:
      return "Tapie 2007, eq 7";
    case FormulaId::path_acceleration:
      return "Essid 2019, eq 24";
    case FormulaId::path_jerk:
      return "Tapie 2007, eq 9 and section 5.2.3";
    case FormulaId::braking_jerk:
      return "Tapie 2007, eq 16";
    case FormulaId::braking_acceleration:
      return "Tapie 2007, eq 16, with the acceleration limit";
    case FormulaId::acceleration_jump:
      return "BRISK of the program";
    case FormulaId::shared_acceleration:
      return "Essid 2019, eq 14 and 24";
    case FormulaId::shared_jerk:
    case FormulaId::jerk_across:
      return "Essid 2019, eq 15 and 24";
    case FormulaId::radial_acceleration:
      return "Tapie 2007, eq 2 and 8";
    case FormulaId::radial_jerk:
      return "Tapie 2007, eq 4 and 9";
    case FormulaId::shared_radial_acceleration:
    case FormulaId::shared_radial_jerk:
    case FormulaId::steady_acceleration:
    case FormulaId::steady_jerk:
      return "Essid 2019, eq 24 and 26";
    case FormulaId::curve_acceleration:
    case FormulaId::curve_jerk:
    case FormulaId::curve_ramp_acceleration:
    case FormulaId::curve_ramp_jerk:
      return "the compressor of Feedscope";
    case FormulaId::arc_blend_radial_jerk:
      return "Gassara 2013, in Essid 2019, section 4.3";
    case FormulaId::curvilinear_jerk:
      return "Tapie 2007, eq 10 and 11";
    case FormulaId::curvature_crossing:
      return "Tapie 2007, eq 13";
    case FormulaId::interpolation_period:
      return "Tapie 2007, eq 6";
    case FormulaId::horizon_jerk:
    case FormulaId::horizon_acceleration:
      return "Msaddek 2011, section 2.2.3";
    case FormulaId::filter_delay:
      return "Ward 2021, eq 8";
    case FormulaId::corner_error:
      return "Ward 2021, eq 25 to 30";
    case FormulaId::arc_error:
      return "Ward 2021, eq 1, on a circle";
    case FormulaId::block_time:
      return "one block each t_b";
    case FormulaId::junction_deviation:
    case FormulaId::square_corner:
    case FormulaId::corner_within_blocks:
    case FormulaId::stop_within_blocks:
    case FormulaId::braking_evenly:
    case FormulaId::path_velocity:
    case FormulaId::level_acceleration:
      return {};  // depends on the model
    case FormulaId::turning_velocity:
    case FormulaId::turning_acceleration:
    case FormulaId::turning_jerk:
    case FormulaId::turning_jump:
    case FormulaId::turning_ramp_acceleration:
    case FormulaId::turning_ramp_jerk:
    case FormulaId::turning_ramp_bend:
      return "chain rule over the kinematics of the machine";
    case FormulaId::whole_acceleration:
    case FormulaId::whole_jerk:
      return "Pham and Pham 2018";
  }
  return {};
}

Reason ElementLimits::made(Cause cause, Formula formula, double reached, std::uint32_t element) const {
  std::string source(source_of(formula.id));
  return {cause, std::move(formula), reached, motion_.trajectory.line_of(element), std::move(source)};
}

}  // namespace feedscope
