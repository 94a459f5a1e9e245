#include "core/models/msaddek/msaddek_model.h"

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/models/explanation/explainer.h"
#include "core/models/msaddek/msaddek_stretch.h"
#include "core/models/shared_settings.h"

namespace feedscope {
namespace {

class MsaddekExplainer : public Explainer {
 public:
  using Explainer::Explainer;

 private:
  bool shares_corners() const override { return false; }
  std::string_view source_of(FormulaId id) const override {
    switch (id) {
      case FormulaId::radial_acceleration:
        return "Msaddek 2011, eq 11";
      case FormulaId::radial_jerk:
        return "Msaddek 2011, eq 15";
      case FormulaId::curvilinear_jerk:
        return "Msaddek 2011, eq 17";
      case FormulaId::curvature_crossing:
        return "Msaddek 2011, eq 3";
      case FormulaId::interpolation_period:
        return "Msaddek 2011, eq 5 and 7";
      default:
        return Explainer::source_of(id);
    }
  }
};

}  // namespace

MsaddekSettings::MsaddekSettings(const Settings& settings)
    : compaction(settings.number("compaction_mm")),
      period(settings.number("interpolation_period_s")),
      curvature_jerk(units::from_m(settings.number("curvilinear_jerk_m_s3")) *
                     settings.number("tangential_share")),
      lookahead(static_cast<std::uint32_t>(settings.number("lookahead_blocks"))),
      law(settings.text("law") == "static" ? MsaddekLaw::static_feed : MsaddekLaw::dynamic_feed),
      compressor(settings) {}

const ModelInfo& MsaddekModel::info() const {
  static const ModelInfo info = [] {
    SettingSpec compaction{
        .key = "compaction_mm",
        .title = QT_TRANSLATE_NOOP("core", "Compaction length"),
        .unit = "mm",
        .explanation = QT_TRANSLATE_NOOP(
            "core",
            "Blocks shorter than this are merged into segments of at most this length where "
            "the tolerance allows it; 0: no compaction. Where the compressor is at work it "
            "takes the place of this."),
        .maximum = 1000,
    };
    SettingSpec law{
        .key = "law",
        .title = QT_TRANSLATE_NOOP("core", "Look-ahead law"),
        .explanation = QT_TRANSLATE_NOOP("core",
                                         "dynamic: ramps planned over the blocks ahead; static: every block "
                                         "at its own feed, as if feed changes took no time."),
        .choices = {QT_TRANSLATE_NOOP("core", "dynamic"), QT_TRANSLATE_NOOP("core", "static")},
    };
    return ModelInfo{
        "msaddek",
        QT_TRANSLATE_NOOP("core", "Connecting arcs, static and dynamic look-ahead (Sinumerik 840D, TNC 430)"),
        "E. B. Msaddek et al., Int J Adv Manuf Technol 53 (2011) 877-888, doi 10.1007/s00170-010-2884-z",
        QT_TRANSLATE_NOOP(
            "core",
            "Connecting arcs are inserted at corners between lines within the contour tolerance (TIT); short "
            "blocks are merged. Static look-ahead assigns one feed to every block and arc; dynamic "
            "look-ahead plans ramps below it. Helices, dwells, rapids and corners at an arc, which the paper "
            "does not cover, keep the static limits of arcs and lines or are exact stops."),
        with_compressor({compaction, law}),
        {"contour_tolerance_mm", "program_tolerance", "interpolation_period_s", "lookahead_blocks",
         "curvilinear_jerk_m_s3", "tangential_share", "merge_collinear_mm", "block_time_ms",
         "exact_stop_window_um"},
        {NC_("core",
             "Points that compaction omits stay within the tolerance of the chord; a corner "
             "blend may deviate from the chord in addition."),
         NC_("core",
             "law dynamic: where curvature jumps, the acceleration changes within one "
             "interpolation period by what the axis jerk allows.")}};
  }();
  return info;
}

Guarantees MsaddekModel::guarantees(const Settings& settings) const {
  const bool compacts = settings.number("compaction_mm") > 0;
  Guarantees promised;
  promised.holds_rotary_ramps = settings.text("law") != "static";
  promised.turning_velocity = 1.01;
  promised.covered = Covered::lines;
  promised.meets_tangent_ends = !compacts;
  promised.follows_compaction = compacts;
  promise_tolerance(promised, settings, compacts ? 2 : 1);
  promised.lines = all_kept();
  promised.arcs = promised.blends = static_arc_limits();
  promise_smooth_curves(promised, settings);
  if (settings.text("law") == "static") {
    promised.lines.acceleration = promised.lines.jerk = {};
    promised.curves.acceleration = promised.curves.jerk = {};
    promised.continuity = Continuity::position;
    promised.limits_jerk = false;
    promised.stops_at_reversals = promised.stops_at_rapids = promised.stops_at_line_corners = false;
  } else {
    promised.follows_brisk = true;
    promised.stops_at_arc_corners = true;
  }
  return promised;
}

Trajectory MsaddekModel::do_simulate(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                                     const Settings& settings, Progress* progress) const {
  const Toolpath& toolpath = *shared;
  MsaddekSettings own(settings);
  if (own.compressor.smooths(toolpath)) {
    own.compaction = 0;
  } else {
    own.compressor.on = false;
  }
  const AxisVectors axes(machine);
  const PathRules rules(toolpath, settings);
  const auto compacted = std::make_shared<const CompactedPath>(compact(toolpath, own.compaction, rules));
  const bool merges = compacted->path.segments.size() < toolpath.segments.size();
  TrajectoryBuilder builder(shared, axes.velocity, merges ? compacted : nullptr);
  builder.set_compaction_error(compacted->deviation);
  const PathRules chord_rules(compacted->path, settings);
  run_stretches(toolpath, builder, progress, rules, [&](TrajectoryBuilder& part) -> StretchRun {
    const auto runner = std::make_shared<MsaddekRunner>(toolpath, *compacted, chord_rules, axes, own, part);
    return [runner](const StretchRange& range, ProgressSteps& steps) { runner->run(range, steps); };
  });
  return builder.finish();
}

Explanation MsaddekModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return MsaddekExplainer(motion, motion.settings.text("law") != "static").explain(state);
}

}  // namespace feedscope
