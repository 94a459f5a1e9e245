#include "core/models/grbl/grbl_model.h"

#include <cmath>
#include <optional>
#include <string_view>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/limits/axis_share.h"
#include "core/models/control_reading.h"
#include "core/models/explanation/explainer.h"
#include "core/models/grbl/grbl_run.h"
#include "core/models/shared_settings.h"
#include "core/program/controls/grbl_reading.h"

namespace feedscope {
namespace {

std::vector<SettingSpec> own_settings() {
  std::vector<SettingSpec> specs{
      {
          .key = "junction_deviation_mm",
          .title = QT_TRANSLATE_NOOP("core", "Junction deviation"),
          .unit = "mm",
          .explanation = QT_TRANSLATE_NOOP(
              "core",
              "$11 of grbl: how far an arc in a corner might leave it; the speed that such an "
              "arc would allow is that of the corner, which itself is run as programmed."),
          .maximum = 10,
          .fallback = 0.01,
      },
      {
          .key = "arc_tolerance_mm",
          .title = QT_TRANSLATE_NOOP("core", "Arc tolerance"),
          .unit = "mm",
          .explanation = QT_TRANSLATE_NOOP(
              "core", "$12 of grbl: how far the chords that arcs are cut into may leave them."),
          .minimum = 1e-4,
          .maximum = 10,
          .fallback = 0.002,
      },
      {
          .key = "buffer_blocks",
          .title = QT_TRANSLATE_NOOP("core", "Planner buffer"),
          .explanation = QT_TRANSLATE_NOOP(
              "core",
              "Blocks that are planned together, the running one included; the last of them "
              "always ends at rest."),
          .minimum = 2,
          .maximum = 1000,
          .whole = true,
          .fallback = 15,
      },
      {
          .key = "idle_delay_ms",
          .title = QT_TRANSLATE_NOOP("core", "Idle delay"),
          .unit = "ms",
          .explanation = QT_TRANSLATE_NOOP(
              "core", "$1 of grbl: time for which the motors hold each time all motion ends."),
          .maximum = 254,
          .fallback = 25,
      },
  };
  SettingSpec timing{
      .key = "step_timing",
      .title = QT_TRANSLATE_NOOP("core", "Step timing"),
      .explanation = QT_TRANSLATE_NOOP("core",
                                       "on: times as the step timer makes them, with whole steps and whole "
                                       "timer counts, where steps per mm are "
                                       "given; off: as planned."),
      .choices = {"on", "off"},
  };
  specs.push_back(std::move(timing));
  specs.push_back(refuse_setting());
  return specs;
}

/// Corners by the junction deviation, and a standstill within the blocks of the planner's buffer.
class GrblExplainer : public Explainer {
 public:
  using Explainer::Explainer;

  Formula junction(CauseKind kind, std::uint32_t element) const override {
    return kind == CauseKind::junction_deviation  ? junction_deviation(element)
           : kind == CauseKind::lookahead_horizon ? stop_within(element)
                                                  : Explainer::junction(kind, element);
  }

  std::string_view source_of(FormulaId id) const override {
    switch (id) {
      case FormulaId::junction_deviation:
        return "grbl 1.1, junction deviation $11";
      case FormulaId::stop_within_blocks:
        return "grbl 1.1, planner buffer";
      case FormulaId::braking_evenly:
        return "grbl 1.1, constant acceleration";
      case FormulaId::path_acceleration:
        return "grbl 1.1, $120 to $122";
      case FormulaId::axis_velocity:
        return "grbl 1.1, $110 to $112";
      default:
        return Explainer::source_of(id);
    }
  }

 private:
  Formula junction_deviation(std::uint32_t element) const {
    const std::optional<HalfTurn> half = half_turn(element);
    if (!half) {
      return {};
    }
    const Vec3 across = (path().curve(element).direction - path().curve(element - 1).direction).normalized();
    const AxisBound bound = axis_share(axes().acceleration, across);
    return {FormulaId::junction_deviation,
            {{Symbol::axis_acceleration, bound.axis, axes().acceleration[bound.axis]},
             {Symbol::normal_part, bound.axis, std::abs(across[bound.axis])},
             {Symbol::junction_deviation, -1, setting("junction_deviation_mm")},
             {Symbol::half_turn_sine, -1, half->sine}}};
  }

  /// Mean constant acceleration over the blocks from `element` on, weighted by their lengths.
  Formula stop_within(std::uint32_t element) const {
    const auto blocks = static_cast<std::uint32_t>(setting("buffer_blocks"));
    double gained = 0;
    double length = 0;
    for (std::uint32_t e = element; e < path().size() && e + 1 - element < blocks; ++e) {
      if (path().kind(e) == ElementKind::dwell) {
        break;
      }
      gained += path_acceleration(e).value() * path().length(e);
      length += path().length(e);
    }
    if (!(length > 0)) {
      return {};
    }
    return {FormulaId::stop_within_blocks,
            {{Symbol::path_acceleration, -1, gained / length}, {Symbol::length_ahead, -1, length}}};
  }
};

}  // namespace

GrblSettings::GrblSettings(const Machine& machine, const Settings& settings)
    : junction_deviation(static_cast<float>(settings.number("junction_deviation_mm"))),
      arc_tolerance(static_cast<float>(settings.number("arc_tolerance_mm"))),
      buffer_blocks(static_cast<std::size_t>(settings.number("buffer_blocks"))),
      idle_delay(units::from_ms(settings.number("idle_delay_ms"))),
      step_timing(settings.text("step_timing") == "on") {
  constexpr double minute = 60;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const char name = coordinate_names[i];
    const AxisDrive* drive = machine.drives.find(name);
    steps[i] = drive == nullptr ? 0 : static_cast<float>(drive->steps_per_mm.value_or(0));
    if (const AxisLimits* axis = machine.axes.find(name)) {
      rate[i] = static_cast<float>(axis->velocity * minute);
      acceleration[i] = static_cast<float>(axis->acceleration) * 3600.0F;
    }
  }
}

const ModelInfo& GrblModel::info() const {
  static const ModelInfo info{
      "grbl",
      QT_TRANSLATE_NOOP("core", "Open control grbl"),
      "grbl 1.1h, rebuilt from a description of its planner and compared with results of its own code",
      QT_TRANSLATE_NOOP(
          "core",
          "Corners are passed at the speed that the junction deviation allows, with constant acceleration "
          "and no "
          "limit of the jerk; arcs are cut into chords. The control plans 15 blocks ahead and must be able "
          "to "
          "stop within them, so that short blocks are slow. Lines that it does not understand are not run."),
      own_settings(),
      {},
      {NC_("core", "No jerk is limited, and in corners the velocity of an axis jumps."),
       NC_("core",
           "Corners between rapids and feed motions follow the rule of all corners; the tool "
           "does not stop there.")},
      true};
  return info;
}

Guarantees GrblModel::guarantees(const Settings& settings) const {
  constexpr double rounding = 1.01;  // of ramps of a few hundredths of a millimetre
  Guarantees promised;
  promised.meets_tangent_ends = false;
  promised.stops_at_rapids = promised.stops_at_reversals = false;
  promised.rounds_places = promised.arcs_are_chords = true;
  promised.begins_again_at_stops = promised.limits_jerk = false;
  if (settings.text("step_timing") == "on") {
    promised.continuity = Continuity::position;
    promised.feed = Guarantees::unbounded;
  } else {
    promised.lines.velocity = {KeptLimit::Of::whole, 1};
    promised.lines.acceleration = {KeptLimit::Of::whole, rounding};
    promised.arcs = promised.lines;
  }
  return promised;
}

ControlReading GrblModel::do_read(const std::shared_ptr<const Toolpath>& toolpath, const Settings& settings,
                                  const Progress* progress) const {
  if (settings.text("refuse") == "off") {
    return {toolpath, {}};
  }
  return reading_of(
      read_as_grbl(toolpath->source, static_cast<float>(settings.number("arc_tolerance_mm")), progress),
      *toolpath, true);
}

Trajectory GrblModel::do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                                  const Settings& settings, Progress* progress) const {
  return GrblRun(toolpath, machine, GrblSettings(machine, settings)).run(progress);
}

Explanation GrblModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return GrblExplainer(motion, false).explain(state);
}

}  // namespace feedscope
