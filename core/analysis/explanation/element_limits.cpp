#include "core/analysis/explanation/element_limits.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/explanation/joint_limits.h"
#include "core/base/units.h"
#include "core/blend/path_rules.h"
#include "core/machine/settings.h"
#include "core/models/tapie/set_point.h"

namespace feedscope {
namespace {

std::size_t axis_of(Cause cause) {
  return static_cast<std::size_t>(cause.axis);
}

/// Smallest limits of ramps over elements [.., last).
struct LeastRamp {
  double acceleration = std::numeric_limits<double>::infinity();
  double jerk = std::numeric_limits<double>::infinity();
};

}  // namespace

ElementLimits::ElementLimits(const Run& run)
    : run_(run),
      path_(run.trajectory->path()),
      traits_(run.setup.model->info().limits),
      axes_(run.setup.machine) {
  if (traits_.along_path) {
    along_.emplace(KlipperSettings(run.setup.machine, run.setup.settings), path_.programmed()->source.get());
  }
}

const KlipperSettings& ElementLimits::limits_along(std::uint32_t element) const {
  return along_->at(path_.programmed()->segments[path_.segment(element)].line);
}

double ElementLimits::setting(std::string_view key) const {
  return run_.setup.settings.number(key);
}

std::size_t ElementLimits::block(std::uint32_t element) const {
  return path_.base_segment_of(element);
}

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
  if (traits_.along_path) {
    return acceleration_along(element);
  }
  if (path_.in_corner(element) && traits_.ramps_share_corners) {
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

/// The control's own limit along the path, or its limit of Z if lower.
Formula ElementLimits::acceleration_along(std::uint32_t element) const {
  constexpr std::int8_t z = 2;
  const KlipperSettings& own = limits_along(element);
  const double part = std::abs(path_.curve(element).direction[z]);
  if (own.max_z_acceleration < part * own.max_acceleration) {
    return {FormulaId::path_acceleration,
            {{Symbol::axis_acceleration, z, own.max_z_acceleration}, {Symbol::tangent_part, z, part}}};
  }
  return {FormulaId::level_acceleration, {{Symbol::largest_acceleration, -1, own.max_acceleration}}};
}

/// Velocity, likewise.
Formula ElementLimits::velocity_along(std::uint32_t element) const {
  constexpr std::int8_t z = 2;
  const KlipperSettings& own = limits_along(element);
  const double part = std::abs(path_.curve(element).direction[z]);
  if (own.max_z_velocity < part * own.max_velocity) {
    return {FormulaId::axis_velocity,
            {{Symbol::axis_velocity, z, own.max_z_velocity}, {Symbol::tangent_part, z, part}}};
  }
  return {FormulaId::path_velocity, {{Symbol::path_velocity, -1, own.max_velocity}}};
}

Formula ElementLimits::path_jerk(std::uint32_t element) const {
  Formula steady;
  if (path_.in_corner(element) && traits_.ramps_share_corners) {
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

Formula ElementLimits::arc_velocity(Cause cause, const Arc& arc) const {
  const std::size_t j = axis_of(cause);
  double part = ArcExtremes(arc).tangent[cause.axis];
  if (traits_.at_steady_place) {
    const SteadyPlace place = steady_place(
        arc, axes_, units::from_m(setting("curvilinear_jerk_m_s3")) * setting("tangential_share"));
    part = std::max(part, std::abs(arc.at(place.angle * arc.length_per_radian()).d1[cause.axis]));
  }
  return {FormulaId::axis_velocity,
          {{Symbol::axis_velocity, cause.axis, axes_.velocity[static_cast<Eigen::Index>(j)]},
           {Symbol::tangent_part, cause.axis, part}}};
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
  Vec3 tangent;
  Vec3 normal;
  if (traits_.at_steady_place) {
    const SteadyPlace place = steady_place(
        arc, axes_, units::from_m(setting("curvilinear_jerk_m_s3")) * setting("tangential_share"));
    const CurvePoint at = arc.at(place.angle * arc.length_per_radian());
    tangent = at.d3 / (k * k);
    normal = at.d2 / k;
  } else {
    const ArcExtremes extremes(arc);
    tangent = extremes.tangent;
    normal = extremes.normal;
  }
  switch (cause.kind) {
    case CauseKind::axis_velocity:
    case CauseKind::rapid:
      return arc_velocity(cause, arc);
    case CauseKind::radial_acceleration:
      return {FormulaId::radial_acceleration,
              {{Symbol::axis_acceleration, cause.axis, axes_.acceleration[cause.axis]},
               radius,
               {Symbol::normal_part, cause.axis, std::abs(normal[cause.axis])}}};
    case CauseKind::radial_jerk:
      return {FormulaId::radial_jerk,
              {{Symbol::axis_jerk, cause.axis, axes_.jerk[cause.axis]},
               radius,
               {Symbol::tangent_part, cause.axis, std::abs(tangent[cause.axis])}}};
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
  if (traits_.along_path && of_velocity) {
    return velocity_along(element);
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
  const double part = std::abs(curve.direction[cause.axis]);
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

/// Mean constant acceleration over the blocks from `element` on, weighted by their lengths.
Formula ElementLimits::stop_within(std::uint32_t element) const {
  const auto blocks = static_cast<std::uint32_t>(setting(traits_.stops_within));
  double gained = 0;
  double length = 0;
  for (std::uint32_t e = element; e < path_.size() && e + 1 - element < blocks; ++e) {
    if (path_.kind(e) == ElementKind::dwell) {
      break;
    }
    gained += path_acceleration(e).value() * path_.length(e);
    length += path_.length(e);
  }
  if (!(length > 0)) {
    return {};
  }
  return {FormulaId::stop_within_blocks,
          {{Symbol::path_acceleration, -1, gained / length}, {Symbol::length_ahead, -1, length}}};
}

Formula ElementLimits::junction_deviation(std::uint32_t element) const {
  const std::optional<HalfTurn> half = half_turn(path_, element);
  if (!half) {
    return {};
  }
  const Vec3 across = (path_.curve(element).direction - path_.curve(element - 1).direction).normalized();
  const AxisBound bound = axis_share(axes_.acceleration, across);
  return {FormulaId::junction_deviation,
          {{Symbol::axis_acceleration, bound.axis, axes_.acceleration[bound.axis]},
           {Symbol::normal_part, bound.axis, std::abs(across[bound.axis])},
           {Symbol::junction_deviation, -1, setting("junction_deviation_mm")},
           {Symbol::half_turn_sine, -1, half->sine}}};
}

Formula ElementLimits::square_corner(std::uint32_t element) const {
  const std::optional<HalfTurn> half = half_turn(path_, element);
  if (!half || half->sine >= 1) {
    return {};
  }
  const Quantity sine{Symbol::half_turn_sine, -1, half->sine};
  const Quantity tangent{Symbol::half_turn_tangent, -1, half->sine / half->cosine};
  Formula least;
  for (const std::uint32_t e : {element - 1, element}) {
    const KlipperSettings& own = limits_along(e);
    const Quantity acceleration{Symbol::path_acceleration, -1, path_acceleration(e).value()};
    for (const Formula& formula :
         {Formula{FormulaId::square_corner,
                  {{Symbol::corner_velocity, -1, own.square_corner_velocity},
                   sine,
                   acceleration,
                   {Symbol::largest_acceleration, -1, own.max_acceleration}}},
          Formula{FormulaId::corner_within_blocks,
                  {acceleration, {Symbol::block_length, -1, path_.length(e)}, tangent}}}) {
      if (least.empty() || formula.value() < least.value()) {
        least = formula;
      }
    }
  }
  return least;
}

Formula ElementLimits::horizon(std::uint32_t element) const {
  if (!traits_.stops_within.empty()) {
    return stop_within(element);
  }
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

}  // namespace feedscope
