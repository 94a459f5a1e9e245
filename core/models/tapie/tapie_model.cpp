#include "core/models/tapie/tapie_model.h"

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/models/explanation/explainer.h"
#include "core/models/tapie/set_point.h"
#include "core/trajectory/stretch.h"

namespace feedscope {
namespace {

/// Limits of an arc where its steady feed is reached.
class TapieExplainer : public Explainer {
 public:
  using Explainer::Explainer;

 private:
  ArcParts parts_of(const Arc& arc) const override {
    const SteadyPlace place = steady_place(
        arc, axes(), units::from_m(setting("curvilinear_jerk_m_s3")) * setting("tangential_share"));
    const CurvePoint at = arc.at(place.angle * arc.length_per_radian());
    const double k = arc.curvature();
    return {ArcExtremes(arc).tangent.cwiseMax(at.d1.cwiseAbs()), at.d3 / (k * k), at.d2 / k};
  }
};

}  // namespace

const ModelInfo& TapieModel::info() const {
  static const ModelInfo info{
      "tapie",
      QT_TRANSLATE_NOOP("core", "Circular interpolation (Sinumerik 840D)"),
      "L. P. Tapie et al., Int J Mach Tools Manuf 47 (2007) 805-819, doi 10.1016/j.ijmachtools.2006.06.021",
      QT_TRANSLATE_NOOP(
          "core",
          "One feed for each arc, from the curvilinear jerk of the control and from what the axes allow "
          "where it is reached; speed is lost at every change of curvature; jerk-limited ramps in between. "
          "Corners are exact stops: the paper states that the control rounds them, but not how."),
      {},
      {"interpolation_period_s", "lookahead_blocks", "curvilinear_jerk_m_s3", "tangential_share",
       "merge_collinear_mm", "block_time_ms", "exact_stop_window_um"},
      {NC_("core",
           "On arcs the tangential and the radial acceleration each keep the axis limits at "
           "the place where the steady feed is reached, and so do the two parts of the jerk "
           "along the path, v'' and v^3 k^2; their sum may exceed them, and elsewhere on the "
           "arc the radial acceleration and v^3 k^2 too, as measured there.")}};
  return info;
}

Guarantees TapieModel::guarantees(const Settings&) const {
  Guarantees promised;
  promised.holds_rotary_ramps = true;
  promised.turning_velocity = 1.01;
  promised.covered = Covered::arcs;
  promised.lines = all_kept();
  promised.follows_brisk = true;
  promised.arcs.velocity = promised.lines.velocity;
  promised.stops_at_line_corners = promised.stops_at_arc_corners = true;
  return promised;
}

Trajectory TapieModel::do_simulate(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                                   const Settings& settings, Progress* progress) const {
  const Toolpath& toolpath = *shared;
  const SetPointRule rule{
      AxisVectors(machine),
      units::from_m(settings.number("curvilinear_jerk_m_s3")) * settings.number("tangential_share"),
      settings.number("interpolation_period_s")};
  const auto lookahead = static_cast<std::uint32_t>(settings.number("lookahead_blocks"));
  TrajectoryBuilder builder(shared, rule.axes.velocity);
  const PathRules rules = PathRules::exact_corners(toolpath);
  run_stretches(toolpath, builder, progress, rules, [&](TrajectoryBuilder& part) -> StretchRun {
    const auto stretch = std::make_shared<Stretch>();
    return [&, stretch](const StretchRange& range, ProgressSteps& steps) {
      stretch->clear();
      for (std::size_t i = range.first; i < range.last; ++i) {
        const auto block = static_cast<std::uint32_t>(i);
        const auto add = [&](const TurnPart* turn, double from, double to) {
          const MotionLimits limits =
              with_joints(rule.limits(toolpath, i, turn), toolpath, i, range.first, range.last);
          stretch->add({to - from, limits}, part.add_segment(block, to - from), block);
        };
        const Segment& segment = toolpath.segments[i];
        if (segment.kind == SegmentKind::arc) {
          add(nullptr, 0, segment.length);
        } else {
          for_turn_parts(toolpath, i, 0, segment.length, add);
        }
      }
      follow_acceleration_mode(*stretch, part.path(), rules, rule.period);
      set_junction_ceilings(*stretch, part.path(), rule.axes.jerk, rule.period, lookahead);
      part_turning(*stretch, part.path());
      add_planned_motion(part, *stretch, plan_nodes(stretch->plan, stretch->ceiling, stretch->held()), steps);
    };
  });
  return builder.finish();
}

Explanation TapieModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return TapieExplainer(motion).explain(state);
}

}  // namespace feedscope
