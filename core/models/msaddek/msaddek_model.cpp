#include "core/models/msaddek/msaddek_model.h"

#include "core/base/units.h"
#include "core/models/msaddek/msaddek_stretch.h"
#include "core/models/shared_settings.h"

namespace feedscope {

MsaddekSettings::MsaddekSettings(const Settings& settings)
    : compaction(settings.number("compaction_mm")),
      period(settings.number("interpolation_period_s")),
      curvature_jerk(units::from_m(settings.number("curvilinear_jerk_m_s3")) *
                     settings.number("tangential_share")),
      lookahead(static_cast<std::uint32_t>(settings.number("lookahead_blocks"))),
      law(settings.text("law") == "static" ? MsaddekLaw::static_feed : MsaddekLaw::dynamic_feed) {}

const ModelInfo& MsaddekModel::info() const {
  static const ModelInfo info = [] {
    SettingSpec compaction;
    compaction.key = "compaction_mm";
    compaction.title = "Compaction length";
    compaction.unit = "mm";
    compaction.explanation =
        "Blocks shorter than this are merged into segments of at most this length where the tolerance allows "
        "it; 0 merges none.";
    compaction.maximum = 1000;
    SettingSpec law;
    law.key = "law";
    law.title = "Look-ahead";
    law.explanation =
        "dynamic: ramps that know the blocks ahead; static: every block at its own feed, as if feed changes "
        "took no time.";
    law.choices = {"dynamic", "static"};
    return ModelInfo{
        "msaddek",
        "Connecting arcs, static and dynamic look-ahead (Sinumerik 840D, TNC 430)",
        "E. B. Msaddek et al., Int J Adv Manuf Technol 53 (2011) 877-888, doi 10.1007/s00170-010-2884-z",
        "Corners between lines get connecting arcs within the contour tolerance (TIT), small blocks are "
        "merged. Static look-ahead gives every block and arc one feed; dynamic look-ahead ramps below it. "
        "Helices, dwells, rapids and corners that touch an arc, which the paper does not cover, keep the "
        "static limits of arcs and lines or are exact stops.",
        {compaction, law},
        {"contour_tolerance_mm", "program_tolerance", "interpolation_period_s", "lookahead_blocks",
         "curvilinear_jerk_m_s3", "tangential_share"},
        {"Points that compaction leaves out stay within the tolerance of the chord, which a corner may cut "
         "once more.",
         "law dynamic: where curvature jumps, the acceleration changes within one interpolation period by "
         "what the axis jerk allows."}};
  }();
  return info;
}

Guarantees MsaddekModel::guarantees(const Settings& settings) const {
  const bool compacts = settings.number("compaction_mm") > 0;
  Guarantees promised;
  promised.covered = Covered::lines;
  promised.meets_tangent_ends = !compacts;
  promised.follows_compaction = compacts;
  promise_tolerance(promised, settings, compacts ? 2 : 1);
  promised.lines = all_kept();
  promised.arcs = promised.blends = static_arc_limits();
  if (settings.text("law") == "static") {
    promised.lines.acceleration = promised.lines.jerk = {};
    promised.continuity = Continuity::position;
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
  const MsaddekSettings own(settings);
  const AxisVectors axes(machine);
  const PathRules rules(toolpath, settings);
  const auto compacted = std::make_shared<const CompactedPath>(compact(toolpath, own.compaction, rules));
  const bool merges = compacted->path.segments.size() < toolpath.segments.size();
  TrajectoryBuilder builder(shared, axes.velocity, merges ? compacted : nullptr);
  builder.set_compaction_error(compacted->deviation);
  const PathRules chord_rules(compacted->path, settings);
  MsaddekRunner runner(toolpath, *compacted, chord_rules, axes, own, builder);
  run_stretches(toolpath, builder, progress, rules,
                [&](const StretchRange& range, ProgressSteps& steps) { runner.run(range, steps); });
  return builder.finish();
}

}  // namespace feedscope
