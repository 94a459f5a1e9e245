#include "core/models/ward/ward_model.h"

#include <algorithm>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/blend/junction.h"
#include "core/blend/path_rules.h"
#include "core/models/explanation/explainer.h"
#include "core/models/ward/corner_pulse.h"
#include "core/models/ward/ward_runner.h"
#include "core/trajectory/filtered_corner.h"
#include "core/trajectory/stretch.h"

namespace feedscope {

WardSettings::WardSettings(const Settings& settings)
    : filters(static_cast<int>(settings.number("filters"))),
      jerk(units::from_m(settings.number("filter_jerk_m_s3"))),
      time(settings.number("filter_time_s")),
      enforce(settings.text("enforce") == "on"),
      compressor(settings) {
  // The tolerance used by the curve of the points is not available where the filters cut bends off, and a
  // small share smooths as well as a large one.
  constexpr double share_of_curve = 0.1;
  compressor.tolerance_share = share_of_curve;
}

namespace {

/// Common settings; off by default, because the source has no such stage and the filters need none.
std::vector<SettingSpec> with_smoothed_points(std::vector<SettingSpec> own) {
  std::vector<SettingSpec> specs = with_compressor(std::move(own));
  SettingSpec& compressor = *std::ranges::find(specs, "compressor", &SettingSpec::key);
  compressor.explanation = QT_TRANSLATE_NOOP(
      "core",
      "Moves the points of dense short blocks onto a smooth curve, within a tenth of the contour tolerance, "
      "before the pulses are made. program: where the program asks for it; off: never; on: everywhere. Our "
      "own addition: the filters smooth by themselves, and no time is gained by it.");
  compressor.choices = {QT_TRANSLATE_NOOP("core", "off"), QT_TRANSLATE_NOOP("core", "program"),
                        QT_TRANSLATE_NOOP("core", "on")};
  return specs;
}

/// Contour error of an arc, or of the corner of `block` nearest in time.
Formula filtered_corner(const FilteredMotion& motion, std::size_t block, double time) {
  const PulseTrain& train = motion.train();
  const double feed = train.blocks[block].feed;
  if (train.segment(block).kind == SegmentKind::arc) {
    const double rate = feed / train.arc(block).length_per_radian();
    return {FormulaId::arc_error,
            {{Symbol::radius, -1, train.arc(block).radius},
             {Symbol::filter_angle, -1, rate * train.filter_time / 2},
             {Symbol::filters, -1, static_cast<double>(train.filters)}}};
  }
  const auto is_corner = [&](std::size_t corner) {
    return corner > 0 && corner < train.size() && corner_turn(train, corner) > straight_angle;
  };
  const auto distance = [&](std::size_t corner) {
    return std::abs(train.blocks[corner].start + train.half_delay() - time);
  };
  const bool later = is_corner(block + 1) && (!is_corner(block) || distance(block + 1) < distance(block));
  const std::size_t corner = later ? block + 1 : block;
  if (!is_corner(corner)) {
    return {};
  }
  const double speed = train.blocks[corner].corner_speed;
  const auto leg = [&](std::size_t side) {
    const double pulse = train.blocks[side].feed;
    return pulse * train.filter_time * corner_distance(train.filters, std::min(speed / pulse, 1.0));
  };
  return {FormulaId::corner_error,
          {{Symbol::leg_before, -1, leg(corner - 1)},
           {Symbol::leg_after, -1, leg(corner)},
           {Symbol::turn, -1, corner_turn(train, corner)}}};
}

/// Pulses are limited, and the filters spread them over time; on settled stretches the pulse of the block
/// counts.
class WardExplainer : public Explainer {
 public:
  using Explainer::Explainer;

 private:
  Reason reason(const State& state, Cause cause) const override {
    return path().kind(state.element) == ElementKind::filtered ? of_filters(state, cause)
                                                               : Explainer::reason(state, cause);
  }

  Reason of_filters(const State& state, Cause cause) const {
    const auto reason = [&](Formula formula, double reached) {
      return this->made(cause, std::move(formula), reached, state.element);
    };
    const FilteredMotion& filtered = trajectory().motion_of(state.element);
    const PulseTrain& train = filtered.train();
    const std::size_t block = path().base_segment_of(state.element) - train.first;
    switch (cause.kind) {
      case CauseKind::velocity_filter:
      case CauseKind::ramp_down:
        return reason({FormulaId::filter_delay,
                       {{Symbol::filters, -1, static_cast<double>(train.filters)},
                        {Symbol::filter_time, -1, train.filter_time}}},
                      filtered.delay());
      case CauseKind::contour_tolerance: {
        const PathRules rules(*path().programmed(), motion().settings);
        const double tolerance = rules.tolerance(path().segment(state.element));
        return reason(filtered_corner(filtered, block, state.time - filtered.start()), tolerance);
      }
      default:
        return reason(speed(cause, state.element), train.blocks[block].feed);
    }
  }
};

}  // namespace

const ModelInfo& WardModel::info() const {
  static const ModelInfo info = [] {
    SettingSpec filters{
        .key = "filters",
        .title = QT_TRANSLATE_NOOP("core", "Number of filters"),
        .explanation = QT_TRANSLATE_NOOP(
            "core",
            "Number of moving averages in series; 3 are closer to the control in the paper, 2 are simpler."),
        .minimum = 2,
        .maximum = 3,
        .whole = true,
        .fallback = 3,
    };
    SettingSpec jerk{
        .key = "filter_jerk_m_s3",
        .title = QT_TRANSLATE_NOOP("core", "Jerk of the filters"),
        .unit = "m/s3",
        .explanation = QT_TRANSLATE_NOOP(
            "core",
            "Used only if the filter time is 0: jerk of a ramp to the highest programmed feed between two "
            "stops; "
            "the filter time is the square root of this feed over the jerk. 0: the smallest axis jerk."),
        .maximum = 1e6,
        .least_above_zero = 1e-3,
    };
    SettingSpec time{
        .key = "filter_time_s",
        .title = QT_TRANSLATE_NOOP("core", "Filter time"),
        .unit = "s",
        .explanation = QT_TRANSLATE_NOOP(
            "core",
            "Length of one moving average, the same for all feeds. 0: computed from the "
            "highest programmed feed between two stops and the jerk of the filters; a higher "
            "programmed feed can then slow the program down."),
        .maximum = 10,
        .least_above_zero = 1e-4,
    };
    SettingSpec enforce{
        .key = "enforce",
        .title = QT_TRANSLATE_NOOP("core", "Keep the tolerance where corners are close"),
        .explanation = QT_TRANSLATE_NOOP(
            "core",
            "on: corners are slowed down until the actual contour error is within the "
            "tolerance; off: every corner is treated as if it were alone, as in the paper."),
        .choices = {QT_TRANSLATE_NOOP("core", "on"), QT_TRANSLATE_NOOP("core", "off")},
    };
    return ModelInfo{
        "ward",
        QT_TRANSLATE_NOOP("core", "Velocity pulses through FIR filters (Heidenhain TNC 640)"),
        "R. Ward et al., Int J Adv Manuf Technol (2021), "
        "Accurate prediction of machining feedrate and cycle times considering interpolator dynamics",
        QT_TRANSLATE_NOOP("core",
                          "Every block is a velocity pulse, reduced around corners until the contour "
                          "tolerance is kept; two or three equal moving averages smooth the pulses of each "
                          "axis. On arcs, which the paper does not cover, the pulses follow the tangent; "
                          "they keep the static limits of Tapie 2007 and, as at corners, the tolerance."),
        with_smoothed_points({filters, jerk, time, enforce}),
        {"contour_tolerance_mm", "program_tolerance", "merge_collinear_mm", "block_time_ms",
         "exact_stop_window_um"},
        {NC_("core",
             "A filtered velocity is an average of commanded ones, which keeps the axes' velocities."),
         NC_("core",
             "Acceleration and jerk follow from the filters alone: a change of feed dF takes "
             "the jerk dF/T1^2; axis limits are not considered."),
         NC_("core", "With three filters the jerk is continuous, too."),
         NC_("core",
             "Tolerance 0: full stops in every corner; on arcs the path is still inside the "
             "programmed one, by the amount that the filters reduce the radius.")}};
  }();
  return info;
}

Guarantees WardModel::guarantees(const Settings& settings) const {
  Guarantees promised;
  promised.covered = Covered::lines;
  promised.lines.velocity.of = KeptLimit::Of::whole;
  promised.arcs = promised.blends = promised.lines;
  promised.feed_of_run = true;
  promised.smooths = settings.text("compressor") != "off";
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
  const WardSettings own(settings);
  PathRules rules(*shared, settings);
  rules.pass_joints();
  const auto smoothed =
      own.compressor.smooths(*shared) ? std::make_shared<Toolpath>(*shared) : std::shared_ptr<Toolpath>();
  run_stretches(
      *shared, builder, progress, rules,
      [&](TrajectoryBuilder& part) -> StretchRun {
        const auto runner = std::make_shared<WardRunner>(shared, smoothed, axes, own, rules, part);
        return [runner](const StretchRange& range, ProgressSteps& steps) { runner->run(range, steps); };
      },
      false);
  return builder.finish();
}

Explanation WardModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return WardExplainer(motion).explain(state);
}

}  // namespace feedscope
