#include "core/models/optimal/optimal_model.h"

#include <algorithm>

#include "core/base/translatable.h"
#include "core/models/explanation/explainer.h"
#include "core/models/optimal/acceleration_law.h"
#include "core/models/optimal/filtered_path.h"
#include "core/models/optimal/jerk_law.h"
#include "core/models/optimal/slowed_law.h"

namespace feedscope {
namespace {

constexpr const char* usual_path = "essid";

/// Largest excess of the limits between the checked places of a curve.
constexpr double between_places = 1.02;
constexpr double jerk_between_places = 1.05;
constexpr double on_filtered_path = 1.06;

/// Permitted deviation of the course of a filtered path, as a share of the contour tolerance.
constexpr double share_of_tolerance = 1e-3;

/// Adds the settings of the models whose paths can be used, each key once.
void add_settings_of_paths(ModelInfo& info, SettingSpec& path) {
  for (const ControlModel* model : all_models()) {
    if (dynamic_cast<const OptimalModel*>(model) != nullptr || model->info().jumps_in_corners) {
      continue;
    }
    const ModelInfo& inner = model->info();
    if (inner.id != usual_path) {
      path.choices.push_back(inner.id);
    }
    for (const std::string& key : inner.uses) {
      if (std::find(info.uses.begin(), info.uses.end(), key) == info.uses.end()) {
        info.uses.push_back(key);
      }
    }
    for (const SettingSpec& spec : inner.settings) {
      const auto same = [&](const SettingSpec& other) { return other.key == spec.key; };
      if (std::none_of(info.settings.begin(), info.settings.end(), same)) {
        info.settings.push_back(spec);
      }
    }
  }
}

ModelInfo make_info() {
  ModelInfo info;
  info.id = "optimal";
  info.title = QT_TRANSLATE_NOOP("core", "Time-optimal bound");
  info.reference = "";
  info.summary =
      QT_TRANSLATE_NOOP("core",
                        "The shortest time in which any control could run the path of another model, "
                        "including its blends, within the axis limits and the programmed feed: what a better "
                        "control could still gain. The settings of the other model shape the path.");
  SettingSpec path;
  path.key = "path";
  path.title = QT_TRANSLATE_NOOP("core", "Path of the model");
  path.explanation = QT_TRANSLATE_NOOP(
      "core",
      "Model whose path is run, including corner blends; for ward the path that its filters produce.");
  path.choices = {usual_path};
  add_settings_of_paths(info, path);
  SettingSpec jerk{
      .key = "jerk",
      .title = QT_TRANSLATE_NOOP("core", "Jerk limits"),
      .explanation = QT_TRANSLATE_NOOP("core",
                                       "off: the fastest within velocity and acceleration limits, which no "
                                       "control can beat; on: also within "
                                       "the jerk of every axis, close to the fastest and slow to compute."),
      .choices = {QT_TRANSLATE_NOOP("core", "off"), QT_TRANSLATE_NOOP("core", "on")},
  };
  info.settings.insert(info.settings.begin(), {path, jerk});
  info.remarks = {
      NC_("core",
          "On blends that nearly reverse, limits were exceeded by up to 5 % (acceleration) and a third "
          "(jerk)."),
      NC_("core",
          "On the path of ward, jerk=on keeps the jerk except for short peaks where an arc begins from a "
          "standstill."),
      NC_("core", "Stops only where the path itself has a kink, a reversal or a dwell."),
      NC_("core", "Kinks of up to 0.01 rad at arcs are treated as tangent, as in every model."),
      NC_("core",
          "Where rotary axes turn the bound is not strict: they hold the tip over each whole block "
          "by their fastest place, along curves and where blocks meet by their velocity and by "
          "what turning takes, not while the tip speeds up; turns between operations take the "
          "time of the machine's jerk.")};
  return info;
}

/// Allowed distance of a fitted path from the filtered motion [mm]: below the least one its curvature would
/// be rounding.
double fit_error(double tolerance) {
  constexpr double least = 1e-7;
  return tolerance > 0 ? std::clamp(share_of_tolerance * tolerance, least, FilteredPath::usual_error)
                       : FilteredPath::usual_error;
}

/// The path of `run`, to be passed in another time.
TrajectoryBuilder path_of(const Trajectory& run, const std::shared_ptr<const Toolpath>& toolpath,
                          const AxisVectors& axes, double tolerance, const Progress* progress) {
  if (run.motions().empty()) {
    return TrajectoryBuilder(run);
  }
  TrajectoryBuilder builder(toolpath, axes.velocity);
  builder.stop_with(progress);
  FilteredPath(run, axes, fit_error(tolerance), builder).lay();
  double contour_error = 0;
  for (const FilteredMotion& motion : run.motions()) {
    contour_error = std::max(contour_error, motion.contour_error());
  }
  builder.set_compaction_error(contour_error);
  return builder;
}

/// Limits of ramps apply to the sum along and across the path.
class OptimalExplainer : public Explainer {
 public:
  using Explainer::Explainer;

 private:
  Reason reason(const State& state, Cause cause) const override {
    return is_of_ramp(cause.kind) ? whole_axis(state, cause) : Explainer::reason(state, cause);
  }

  Reason whole_axis(const State& state, Cause cause) const {
    const bool by_jerk = cause.kind == CauseKind::axis_jerk;
    const bool blend = path().in_corner(state.element);
    const Vec3& limit = !by_jerk ? axes().acceleration : blend ? axes().blend_jerk : axes().jerk;
    const Vec3& whole = by_jerk ? state.jerk : state.acceleration;
    std::int8_t j = cause.axis;
    for (std::int8_t axis = 0; cause.axis < 0 && axis < 3; ++axis) {
      j = j < 0 || std::abs(whole[axis]) * limit[j] > std::abs(whole[j]) * limit[axis] ? axis : j;
    }
    const Vec3 tangent = state.speed > 0 ? Vec3(state.velocity / state.speed) : Vec3(Vec3::Zero());
    const double along = tangent[j] * (by_jerk ? state.tangential_jerk : state.tangential_acceleration);
    const Quantity part_along{by_jerk ? Symbol::jerk_along : Symbol::acceleration_along, j, along};
    const Quantity part_across{by_jerk ? Symbol::jerk_across : Symbol::acceleration_across, j,
                               whole[j] - along};
    return made(cause,
                {by_jerk ? FormulaId::whole_jerk : FormulaId::whole_acceleration, {part_along, part_across}},
                limit[j], state.element);
  }
};

}  // namespace

const ModelInfo& OptimalModel::info() const {
  static const ModelInfo info = make_info();
  return info;
}

Guarantees OptimalModel::guarantees(const Settings& settings) const {
  const Guarantees inner = find_model(settings.text("path")).guarantees(settings);
  Guarantees promised;
  promised.limits_jerk = settings.text("jerk") == "on";
  promised.lines.velocity = promised.lines.acceleration = {KeptLimit::Of::whole};
  promised.arcs = promised.blends = promised.lines;
  promised.arcs.acceleration.factor = promised.blends.acceleration.factor = between_places;
  promised.arcs.velocity.factor = promised.blends.velocity.factor = between_places;
  if (settings.text("jerk") == "on" && !inner.feed_of_run) {
    promised.lines.jerk = {KeptLimit::Of::whole};
    promised.arcs.jerk = promised.blends.jerk = {KeptLimit::Of::whole, jerk_between_places};
    promised.blends.of_blend_jerk = true;
  }
  promised.smooths = inner.smooths;
  promised.lays_curves = inner.lays_curves;
  promised.follows_compaction = inner.follows_compaction;
  promised.curves = promised.blends;
  promised.curves.of_blend_jerk = false;
  promised.contour = inner.contour;
  if (inner.feed_of_run) {  // a filtered path turns anywhere
    promised.arcs.acceleration.factor = on_filtered_path;
    promised.lines = promised.arcs;
    const double tolerance = settings.number("contour_tolerance_mm");
    promised.contour += tolerance > 0 ? fit_error(tolerance) / tolerance : 0;
  }
  promised.meets_tangent_ends = inner.meets_tangent_ends;
  promised.stops_at_line_corners = inner.contour == 0;
  promised.stops_at_arc_corners = inner.meets_tangent_ends;  // compaction turns lines at their ends
  promised.stops_at_rapids = false;
  return promised;
}

Trajectory OptimalModel::do_simulate(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                                     const Settings& settings, Progress* progress) const {
  const Toolpath& toolpath = *shared;
  const AxisVectors axes(machine);
  const ControlModel& model = find_model(settings.text("path"));
  const MachinePath placed{shared, {}};
  const bool with_jerk = settings.text("jerk") == "on";  // it uses the model's law where that is faster
  const Trajectory model_run = with_jerk ? model.simulate(placed, machine, settings, progress) : Trajectory();
  const bool can_be_run =
      model.guarantees(settings).continuity != Continuity::position && model_run.motions().empty();
  const auto lay_path_of = [&](const Trajectory& run) {
    return path_of(run, shared, axes, settings.number("contour_tolerance_mm"), progress);
  };
  TrajectoryBuilder builder =
      with_jerk ? lay_path_of(model_run) : lay_path_of(model.lay_path(placed, machine, settings, progress));
  builder.stop_with(progress);
  const SlowedLaw slowed_law(model_run, axes);
  AccelerationLaw acceleration_law(axes, 1, builder);
  JerkLaw jerk_law(axes, builder);
  const BlendedPath& path = builder.path();
  const auto count = static_cast<std::uint32_t>(path.size());
  ProgressSteps steps(progress, toolpath.segments.size());
  for (std::uint32_t first = 0; first < count;) {
    std::uint32_t last = first + 1;
    while (last < count && !is_stop(path, last)) {
      ++last;
    }
    if (path.kind(first) == ElementKind::dwell) {
      builder.pass_pause(first);
    } else if (with_jerk) {
      const TrajectoryBuilder::Mark start = builder.mark();
      jerk_law.run(first, last, steps);
      if (can_be_run) {
        slowed_law.replace_slower(first, last, start, builder);
      }
    } else {
      acceleration_law.run(first, last, steps);
    }
    first = last;
  }
  return builder.finish();
}

Explanation OptimalModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return OptimalExplainer(motion, false).explain(state);
}

}  // namespace feedscope
