#include "core/models/ward/ward_model.h"

#include "core/base/units.h"
#include "core/models/ward/ward_runner.h"
#include "core/trajectory/stretch.h"

namespace feedscope {

WardSettings::WardSettings(const Settings& settings)
    : filters(static_cast<int>(settings.number("filters"))),
      jerk(units::from_m(settings.number("filter_jerk_m_s3"))),
      time(settings.number("filter_time_s")),
      enforce(settings.text("enforce") == "on") {}

const ModelInfo& WardModel::info() const {
  static const ModelInfo info = [] {
    SettingSpec filters;
    filters.key = "filters";
    filters.title = "Number of filters";
    filters.explanation =
        "Moving averages in a row; 3 come closer to the control of the paper, 2 are simpler.";
    filters.minimum = 2;
    filters.maximum = 3;
    filters.whole = true;
    filters.fallback = 3;
    SettingSpec jerk;
    jerk.key = "filter_jerk_m_s3";
    jerk.title = "Jerk of the filters";
    jerk.unit = "m/s3";
    jerk.explanation =
        "Only where the filter time is 0: jerk of a ramp to the largest programmed feed of a stretch, from "
        "which the filter time follows as the square root of feed over jerk. 0: the smallest jerk of the "
        "axes.";
    jerk.maximum = 1e6;
    SettingSpec time;
    time.key = "filter_time_s";
    time.title = "Filter time";
    time.unit = "s";
    time.explanation =
        "Length of one moving average, the same for all feeds. 0: from the largest programmed feed and the "
        "jerk "
        "of the filters, stop by stop; a higher programmed feed can then slow the program down.";
    time.maximum = 10;
    SettingSpec enforce;
    enforce.key = "enforce";
    enforce.title = "Keep the tolerance where corners are close";
    enforce.explanation =
        "on: corners are slowed until the true contour error keeps the tolerance; off: every corner as if it "
        "were "
        "alone, as in the paper.";
    enforce.choices = {"on", "off"};
    return ModelInfo{
        "ward",
        "Velocity pulses through FIR filters (Heidenhain TNC 640)",
        "R. Ward et al., Int J Adv Manuf Technol (2021), "
        "Accurate prediction of machining feedrate and cycle times considering interpolator dynamics",
        "Every block is a velocity pulse, lowered around corners so far that the contour tolerance is kept; "
        "two or "
        "three equal moving averages smooth the pulses of each axis. On arcs, which the paper does not "
        "cover, "
        "the "
        "pulses turn; they keep the static limits of Tapie 2007, and the tolerance as corners do.",
        {filters, jerk, time, enforce},
        {"contour_tolerance_mm", "program_tolerance"},
        {"A filtered velocity is an average of commanded ones, which keeps the axes' velocities.",
         "Acceleration and jerk follow from the filters alone: a change of feed dF takes the jerk dF/T1^2; "
         "the axes' limits are not looked at.",
         "With three filters the jerk is continuous, too.",
         "Tolerance 0: full stops in every corner; on arcs the path still lies inside, by what the filters "
         "take off the radius."}};
  }();
  return info;
}

Guarantees WardModel::guarantees(const Settings& settings) const {
  Guarantees promised;
  promised.covered = Covered::lines;
  promised.lines.velocity.of = KeptLimit::Of::whole;
  promised.arcs = promised.blends = promised.lines;
  promised.feed_of_run = true;
  const bool exact = settings.number("contour_tolerance_mm") == 0;
  promised.contour = WardSettings(settings).enforce && !exact ? 1 : Guarantees::unbounded;
  promised.stops_at_line_corners = promised.stops_at_arc_corners = exact;
  promised.meets_tangent_ends = false;
  promised.continuity = Continuity::acceleration;
  return promised;
}

Trajectory WardModel::do_simulate(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                                  const Settings& settings, Progress* progress) const {
  const AxisVectors axes(machine);
  TrajectoryBuilder builder(shared, axes.velocity);
  const std::size_t count = shared->segments.size();
  builder.reserve(count, count + count / 4);
  {
    const WardSettings own(settings);
    const PathRules rules(*shared, settings);
    WardRunner runner(shared, axes, own, rules, builder);
    run_stretches(
        *shared, builder, progress, rules,
        [&](const StretchRange& range, ProgressSteps& steps) { runner.run(range, steps); }, false);
  }
  return builder.finish();
}

}  // namespace feedscope
