#include "core/models/essid/essid_model.h"

#include <memory>

#include "core/base/translatable.h"
#include "core/models/essid/essid_runner.h"
#include "core/models/essid/essid_settings.h"
#include "core/models/shared_settings.h"

namespace feedscope {
EssidSettings::EssidSettings(const Settings& settings) {
  corner.alpha = settings.number("alpha");
  corner.beta = settings.number("beta");
  const std::string& name = settings.text("reading");
  reading = name == "strict"      ? EssidReading::strict
            : name == "published" ? EssidReading::published
                                  : EssidReading::corrected;
  period = settings.number("interpolation_period_s");
  lookahead = static_cast<std::uint32_t>(settings.number("lookahead_blocks"));
  radial_acceleration_share = settings.number("radial_acceleration_share");
  radial_jerk_share = settings.number("radial_jerk_share");
}

const ModelInfo& EssidModel::info() const {
  static const ModelInfo info = [] {
    SettingSpec alpha{
        .key = "alpha",
        .title = QT_TRANSLATE_NOOP("core", "Tangent weight alpha"),
        .explanation = QT_TRANSLATE_NOOP(
            "core", "Weight of the end tangents of a blend; 2.5 was identified on a Sinumerik 840D."),
        .minimum = 0.5,
        .maximum = 3.5,
        .fallback = 2.5,
    };
    SettingSpec reading{
        .key = "reading",
        .title = QT_TRANSLATE_NOOP("core", "Interpretation of the paper"),
        .explanation = QT_TRANSLATE_NOOP(
            "core",
            "corrected: the acceleration continues after a blend; published: it drops to zero "
            "there, as in the figures of the paper; strict: constant du/dt on a blend, ramps "
            "where blends meet, every limit kept."),
        .choices = {QT_TRANSLATE_NOOP("core", "corrected"), QT_TRANSLATE_NOOP("core", "published"),
                    QT_TRANSLATE_NOOP("core", "strict")},
    };
    return ModelInfo{
        "essid",
        QT_TRANSLATE_NOOP("core", "Local smoothing by cubic blends (Sinumerik 840D)"),
        "M. Essid et al., Int J Adv Manuf Technol 105 (2019) 457-470, doi 10.1007/s00170-019-04157-4",
        QT_TRANSLATE_NOOP("core",
                          "Corners between lines are blended by cubic Hermite curves within the contour "
                          "tolerance; jerk-limited ramps on the lines, per-axis limits with radial shares on "
                          "the blends, look-ahead over a number of blocks. Arcs and tangent junctions, which "
                          "the paper does not cover, keep the static limits of Tapie 2007."),
        with_compressor({alpha, used_tolerance_setting(), reading}),
        {"contour_tolerance_mm", "program_tolerance", "interpolation_period_s", "lookahead_blocks",
         "radial_acceleration_share", "radial_jerk_share", "merge_collinear_mm", "block_time_ms",
         "exact_stop_window_um"},
        {NC_("core",
             "reading corrected, published: at the entry of a blend the radial shares of "
             "acceleration and jerk are kept. Further on, with equal axes and shares of 0.2, "
             "the acceleration stays within 1.01 and the jerk within 2.2 times the limit; the "
             "curvature grows up to five times, and other axes bear it.")}};
  }();
  return info;
}

Guarantees EssidModel::guarantees(const Settings& settings) const {
  const bool strict = settings.text("reading") == "strict";
  constexpr double sampled = 1.01;  // the law on a blend is checked once per sample
  using Of = KeptLimit::Of;
  Guarantees promised;
  promised.holds_rotary_ramps = !strict;
  promised.turning_velocity = sampled;
  promised.covered = Covered::lines;
  promised.feed = strict ? 1 : sampled;
  promised.lines = all_kept();
  promised.lines.velocity.factor = promised.feed;
  promised.arcs = static_arc_limits();
  promised.blends.velocity = {Of::whole, promised.feed};
  if (strict) {
    promised.blends = all_kept();
    promised.blends.of_blend_jerk = true;
  }
  promised.follows_brisk = true;
  promised.stops_at_arc_corners = true;
  promise_tolerance(promised, settings, 1);
  promise_smooth_curves(promised, settings);
  return promised;
}

Trajectory EssidModel::do_simulate(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                                   const Settings& settings, Progress* progress) const {
  const Toolpath& toolpath = *shared;
  TrajectoryBuilder builder(shared, axis_limit_vector(machine, &AxisLimits::velocity));
  const EssidSettings own(settings);
  builder.set_blend_weight(own.corner.alpha);
  const PathRules rules(toolpath, settings);
  run_stretches(toolpath, builder, progress, rules, [&](TrajectoryBuilder& part) -> StretchRun {
    const auto runner = std::make_shared<EssidRunner>(toolpath, AxisVectors(machine), own, rules,
                                                      CompressorSettings(settings), part);
    return [runner](const StretchRange& range, ProgressSteps& steps) { runner->run(range, steps); };
  });
  return builder.finish();
}

Trajectory EssidModel::do_lay_path(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                                   const Settings& settings, Progress* progress) const {
  const Vec3 axis_velocity = axis_limit_vector(machine, &AxisLimits::velocity);
  TrajectoryBuilder builder(shared, axis_velocity);
  const CornerRule rule = EssidSettings(settings).corner;
  const GentleBlendLength gentle(rule.alpha);
  builder.set_blend_weight(rule.alpha);
  const PathRules rules(*shared, settings);
  lay_blended_path(*shared, axis_velocity, rules, CompressorSettings(settings), builder, progress,
                   [&](const CornerPlace& place) { return lay_blend(place, rule, gentle); });
  return builder.finish();
}

}  // namespace feedscope
