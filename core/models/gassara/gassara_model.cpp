#include "core/models/gassara/gassara_model.h"

#include <cmath>
#include <string_view>

#include "core/base/translatable.h"
#include "core/blend/corner.h"
#include "core/models/explanation/explainer.h"
#include "core/models/shared_settings.h"
#include "core/trajectory/blend_chains.h"
#include "core/trajectory/blended_stretch.h"

namespace feedscope {
namespace {

/// Settings of the model in internal units.
struct GassaraSettings {
  CornerRule corner;
  double period;  ///< [s]
  std::uint32_t lookahead;
  double radial_acceleration_share;
  double radial_jerk_share;

  explicit GassaraSettings(const Settings& settings)
      : period(settings.number("interpolation_period_s")),
        lookahead(static_cast<std::uint32_t>(settings.number("lookahead_blocks"))),
        radial_acceleration_share(settings.number("radial_acceleration_share")),
        radial_jerk_share(settings.number("radial_jerk_share")) {
    corner.beta = settings.number("beta");
  }
};

/// Least axis limit over the axes that move by more than the rounding of coordinates at `place`.
AxisBound least_of_axes(const Vec3& limit, const CornerPlace& place) {
  constexpr double moves = 1e-6;  // of the path
  AxisBound least{std::numeric_limits<double>::infinity(), -1};
  for (int j = 0; j < 3; ++j) {
    if (std::abs(place.in[j]) + std::abs(place.out[j]) > moves && limit[j] < least.value) {
      least = {limit[j], static_cast<std::int8_t>(j)};
    }
  }
  return least;
}

/// min(F, V, sqrt(R_A A R), cbrt((1 - R_J) Jtb R^2)) on an arc of `radius` R, and the limits left along it:
/// at constant speed the acceleration v^2/R lies across the path, the jerk v^3/R^2 along it.
MotionLimits arc_blend_limits(const CornerPlace& place, double radius, const AxisVectors& axes,
                              const GassaraSettings& settings) {
  const AxisBound velocity = least_of_axes(axes.velocity, place);
  const AxisBound acceleration = least_of_axes(axes.acceleration, place);
  const AxisBound jerk = least_of_axes(axes.blend_jerk, place);
  const double radial = settings.radial_acceleration_share * acceleration.value;
  const double along_jerk = (1 - settings.radial_jerk_share) * jerk.value;
  MotionLimits limits{place.feed, {acceleration.value - radial, acceleration.axis}, {along_jerk, jerk.axis}};
  limits.speed.lower(velocity.value, {CauseKind::blend_velocity, velocity.axis});
  limits.speed.lower(std::sqrt(radial * radius), {CauseKind::blend_radial_acceleration, acceleration.axis});
  limits.speed.lower(std::cbrt(along_jerk * radius * radius), {CauseKind::blend_tangential_jerk, jerk.axis});
  return limits;
}

/// Ramps over an arc of `radius` whose limits at one speed are `level`: v' <= (1 - R_A) A, and of the jerk
/// v'' + v^3/R^2 <= (1 - R_J) Jtb along the path and 3 v v'/R <= R_J Jtb across it.
BlendRamps arc_blend_ramps(const MotionLimits& level, double radius, const GassaraSettings& settings) {
  const double along = level.jerk.value;
  const double across = along * settings.radial_jerk_share / (1 - settings.radial_jerk_share);
  const double turning = std::sqrt(level.acceleration.value * settings.radial_acceleration_share /
                                   (1 - settings.radial_acceleration_share) * radius);
  const double ramping = std::cbrt(along * radius * radius);
  BlendRamps ramps;
  for (std::size_t step = 0; step < ramps.size(); ++step) {
    const double v = blend_ramp_speed(step, turning, ramping);
    AxisBound acceleration = level.acceleration;
    if (across * radius / (3 * v) < acceleration.value) {
      acceleration = {across * radius / (3 * v), level.jerk.axis};
    }
    ramps[step] = {v, acceleration, {along - v * v * v / (radius * radius), level.jerk.axis}};
  }
  return ramps;
}

struct LaidArc {
  double radius;      ///< [mm]
  CornerPiece piece;  ///< without limits
};

LaidArc lay_arc(const CornerPlace& place, CornerRule rule) {
  rule.tolerance = place.tolerance;
  const Corner corner = lay_arc_corner(place.in, place.out, place.longest, rule);
  const double radius = corner.transition / std::tan(corner.turn / 2);
  return {radius, {ElementKind::connecting_arc, corner.transition, radius * corner.turn, {}}};
}

class GassaraExplainer : public Explainer {
 public:
  using Explainer::Explainer;

  std::string_view source_of(FormulaId id) const override {
    switch (id) {
      case FormulaId::shared_radial_acceleration:
      case FormulaId::shared_radial_jerk:
      case FormulaId::steady_acceleration:
      case FormulaId::steady_jerk:
        return "Gassara 2013, in Essid 2019, section 4.3";
      default:
        return Explainer::source_of(id);
    }
  }
};

}  // namespace

const ModelInfo& GassaraModel::info() const {
  static const ModelInfo info{
      "gassara",
      QT_TRANSLATE_NOOP("core", "Circular-arc blends at constant speed"),
      "B. Gassara et al., Mach Sci Technol 17 (2013) 181-208, doi 10.1080/10910344.2013.780537, as compared "
      "in "
      "Essid et al. 2019, section 4.3",
      QT_TRANSLATE_NOOP(
          "core",
          "Corners between lines are blended by circular arcs within the contour tolerance and passed at "
          "constant speed; where blends meet, they are passed within ramps. Limits apply along tangent and "
          "normal instead of per axis; jerk-limited ramps on the lines, look-ahead. Arcs and tangent "
          "junctions keep the static limits of Tapie 2007."),
      {used_tolerance_setting()},
      {"contour_tolerance_mm", "program_tolerance", "interpolation_period_s", "lookahead_blocks",
       "radial_acceleration_share", "radial_jerk_share", "merge_collinear_mm", "block_time_ms",
       "exact_stop_window_um"},
      {NC_(
          "core",
          "On blends the shares of the least acceleration and jerk of the axes are kept: of the acceleration "
          "R_A across and 1 - R_A along the path, of the jerk R_J across and 1 - R_J along it.")}};
  return info;
}

Guarantees GassaraModel::guarantees(const Settings& settings) const {
  Guarantees promised;
  promised.holds_rotary_ramps = true;
  promised.turning_velocity = 1.01;
  promised.covered = Covered::lines;
  promised.lines = promised.blends = all_kept();
  promised.blends.of_blend_jerk = true;
  promised.arcs = static_arc_limits();
  promised.follows_brisk = true;
  promised.stops_at_arc_corners = true;
  promise_tolerance(promised, settings, 1);
  return promised;
}

Trajectory GassaraModel::do_simulate(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                                     const Settings& settings, Progress* progress) const {
  const Toolpath& toolpath = *shared;
  const GassaraSettings own(settings);
  const AxisVectors axes(machine);
  TrajectoryBuilder builder(shared, axes.velocity);
  const PathRules rules(toolpath, settings);
  const auto blend_corner = [&](const CornerPlace& place) {
    LaidArc arc = lay_arc(place, own.corner);
    arc.piece.limits = arc_blend_limits(place, arc.radius, axes, own);
    return arc.piece;
  };
  run_stretches(toolpath, builder, progress, rules, [&](TrajectoryBuilder& part) -> StretchRun {
    const auto stretch = std::make_shared<Stretch>();
    const auto none = std::make_shared<Compressor>(toolpath, rules, CompressorSettings());
    return [&, stretch, none](const StretchRange& range, ProgressSteps& steps) {
      const BlendedPath& path = part.path();
      lay_blended_stretch(toolpath, range, axes, rules, *none, part, *stretch, blend_corner);
      follow_acceleration_mode(*stretch, path, rules, own.period);
      set_junction_ceilings(*stretch, path, axes.jerk, own.period, own.lookahead);
      part_turning(*stretch, path);
      const auto ramps = [&](std::size_t e) {
        return arc_blend_ramps(stretch->plan[e].limits(), path.min_radius(path.index(stretch->element(e))),
                               own);
      };
      const std::vector<PlanNode> nodes = plan_over_blends(*stretch, ramps, [&] { steps.at(range.first); });
      add_planned_motion(part, *stretch, nodes, steps);
    };
  });
  return builder.finish();
}

Trajectory GassaraModel::do_lay_path(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                                     const Settings& settings, Progress* progress) const {
  const GassaraSettings own(settings);
  const Vec3 axis_velocity = axis_limit_vector(machine, &AxisLimits::velocity);
  TrajectoryBuilder builder(shared, axis_velocity);
  const PathRules rules(*shared, settings);
  lay_blended_path(*shared, axis_velocity, rules, {}, builder, progress,
                   [&](const CornerPlace& place) { return lay_arc(place, own.corner).piece; });
  return builder.finish();
}

Explanation GassaraModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return GassaraExplainer(motion).explain(state);
}

}  // namespace feedscope
