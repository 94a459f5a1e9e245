#include "core/models/klipper/klipper_model.h"

#include <cmath>
#include <optional>
#include <string_view>

#include "core/base/translatable.h"
#include "core/models/control_reading.h"
#include "core/models/explanation/explainer.h"
#include "core/models/klipper/klipper_run.h"
#include "core/program/controls/klipper_limits.h"
#include "core/program/controls/klipper_reading.h"

namespace feedscope {
namespace {

std::vector<SettingSpec> own_settings() {
  std::vector<SettingSpec> specs{
      {
          .key = "max_velocity_m_min",
          .title = QT_TRANSLATE_NOOP("core", "Maximum velocity"),
          .unit = "m/min",
          .explanation = QT_TRANSLATE_NOOP(
              "core",
              "max_velocity of Klipper: of the tool along the path. Without a value the least "
              "of the axes."),
          .minimum = 1e-6,
          .maximum = 1e9,
          .optional = true,
      },
      {
          .key = "max_acceleration_m_s2",
          .title = QT_TRANSLATE_NOOP("core", "Maximum acceleration"),
          .unit = "m/s2",
          .explanation = QT_TRANSLATE_NOOP(
              "core",
              "max_accel of Klipper: of the tool along the path. Without a value the least of "
              "the axes."),
          .minimum = 1e-6,
          .maximum = 1e9,
          .optional = true,
      },
      {
          .key = "square_corner_velocity_mm_s",
          .title = QT_TRANSLATE_NOOP("core", "Square corner velocity"),
          .unit = "mm/s",
          .explanation =
              QT_TRANSLATE_NOOP("core",
                                "Speed at which the tool may pass a corner of 90 degrees; other corners "
                                "accordingly."),
          .maximum = 1e6,
          .fallback = 5,
      },
      {
          .key = "minimum_cruise_ratio",
          .title = QT_TRANSLATE_NOOP("core", "Minimum cruise ratio"),
          .explanation = QT_TRANSLATE_NOOP(
              "core",
              "Part of a way between two slow places that is left for constant speed, so that "
              "short zigzags do not accelerate all the time."),
          .maximum = 0.999,
          .fallback = 0.5,
      },
      {
          .key = "arc_resolution_mm",
          .title = QT_TRANSLATE_NOOP("core", "Arc resolution"),
          .unit = "mm",
          .explanation = QT_TRANSLATE_NOOP("core", "Length of the chords that arcs are cut into."),
          .minimum = 1e-3,
          .maximum = 1e6,
          .fallback = 1,
      },
      {
          .key = "max_z_velocity_m_min",
          .title = QT_TRANSLATE_NOOP("core", "Maximum velocity of Z"),
          .unit = "m/min",
          .explanation = QT_TRANSLATE_NOOP("core", "Without a value that along the path."),
          .minimum = 1e-6,
          .maximum = 1e9,
          .optional = true,
      },
      {
          .key = "max_z_acceleration_m_s2",
          .title = QT_TRANSLATE_NOOP("core", "Maximum acceleration of Z"),
          .unit = "m/s2",
          .explanation = QT_TRANSLATE_NOOP("core", "Without a value that along the path."),
          .minimum = 1e-6,
          .maximum = 1e9,
          .optional = true,
      },
  };
  specs.push_back({
      .key = "max_extrude_velocity_mm_s",
      .title = QT_TRANSLATE_NOOP("core", "Maximum velocity of the extruder alone"),
      .unit = "mm/s",
      .explanation =
          QT_TRANSLATE_NOOP("core",
                            "max_extrude_only_velocity of Klipper. Without a value that for a nozzle "
                            "of 0.4 mm and a filament of 1.75 mm: 0.27 times that along the path."),
      .minimum = 1e-6,
      .maximum = 1e9,
      .optional = true,
  });
  specs.push_back({
      .key = "max_extrude_acceleration_m_s2",
      .title = QT_TRANSLATE_NOOP("core", "Maximum acceleration of the extruder alone"),
      .unit = "m/s2",
      .explanation =
          QT_TRANSLATE_NOOP("core",
                            "max_extrude_only_accel of Klipper. Without a value that for a nozzle of "
                            "0.4 mm and a filament of 1.75 mm: 0.27 times that along the path."),
      .minimum = 1e-6,
      .maximum = 1e9,
      .optional = true,
  });
  specs.push_back(refuse_setting());
  return specs;
}

/// Limits along the path, with their own for Z, that the program may change from line to line.
class KlipperExplainer : public Explainer {
 public:
  explicit KlipperExplainer(const SimulatedMotion& motion)
      : Explainer(motion, false),
        limits_(KlipperSettings(motion.machine, motion.settings), path().programmed()->source.get()) {}

  Formula path_acceleration(std::uint32_t element) const override {
    const KlipperSettings& own = limits_at(element);
    const double part = part_of_z(element);
    if (own.max_z_acceleration < part * own.max_acceleration) {
      return {FormulaId::path_acceleration,
              {{Symbol::axis_acceleration, z, own.max_z_acceleration}, {Symbol::tangent_part, z, part}}};
    }
    return {FormulaId::level_acceleration, {{Symbol::largest_acceleration, -1, own.max_acceleration}}};
  }

  Formula junction(CauseKind kind, std::uint32_t element) const override {
    return kind == CauseKind::square_corner_velocity ? square_corner(element)
                                                     : Explainer::junction(kind, element);
  }

  std::string_view source_of(FormulaId id) const override {
    switch (id) {
      case FormulaId::square_corner:
        return "Klipper, square corner velocity";
      case FormulaId::corner_within_blocks:
        return "Klipper, corner within half of each block";
      case FormulaId::braking_evenly:
        return "Klipper, constant acceleration";
      case FormulaId::path_velocity:
        return "Klipper, max_velocity";
      case FormulaId::level_acceleration:
        return "Klipper, max_accel";
      case FormulaId::path_acceleration:
        return "Klipper, max_z_accel";
      case FormulaId::axis_velocity:
        return "Klipper, max_z_velocity";
      default:
        return Explainer::source_of(id);
    }
  }

 private:
  static constexpr std::int8_t z = 2;

  const KlipperSettings& limits_at(std::uint32_t element) const {
    return limits_.at(path().programmed()->segments[path().segment(element)].line);
  }

  double part_of_z(std::uint32_t element) const { return std::abs(path().curve(element).direction[z]); }

  std::optional<Formula> velocity_of_control(std::uint32_t element) const override {
    const KlipperSettings& own = limits_at(element);
    const double part = part_of_z(element);
    if (own.max_z_velocity < part * own.max_velocity) {
      return Formula{FormulaId::axis_velocity,
                     {{Symbol::axis_velocity, z, own.max_z_velocity}, {Symbol::tangent_part, z, part}}};
    }
    return Formula{FormulaId::path_velocity, {{Symbol::path_velocity, -1, own.max_velocity}}};
  }

  Formula square_corner(std::uint32_t element) const {
    const std::optional<HalfTurn> half = half_turn(element);
    if (!half || half->sine >= 1) {
      return {};
    }
    const Quantity sine{Symbol::half_turn_sine, -1, half->sine};
    const Quantity tangent{Symbol::half_turn_tangent, -1, half->sine / half->cosine};
    Formula least;
    for (const std::uint32_t e : {element - 1, element}) {
      const KlipperSettings& own = limits_at(e);
      const Quantity acceleration{Symbol::path_acceleration, -1, path_acceleration(e).value()};
      for (const Formula& formula :
           {Formula{FormulaId::square_corner,
                    {{Symbol::corner_velocity, -1, own.square_corner_velocity},
                     sine,
                     acceleration,
                     {Symbol::largest_acceleration, -1, own.max_acceleration}}},
            Formula{FormulaId::corner_within_blocks,
                    {acceleration, {Symbol::block_length, -1, path().length(e)}, tangent}}}) {
        if (least.empty() || formula.value() < least.value()) {
          least = formula;
        }
      }
    }
    return least;
  }

  KlipperLimits limits_;
};

}  // namespace

const ModelInfo& KlipperModel::info() const {
  static const ModelInfo info{
      "klipper",
      QT_TRANSLATE_NOOP("core", "Open control Klipper"),
      "Klipper of 2025, rebuilt from a description of its look-ahead and compared with results of its own "
      "code",
      QT_TRANSLATE_NOOP(
          "core",
          "Velocity and acceleration are limited along the path; corners are passed as they are programmed, "
          "at a "
          "speed that the square corner velocity sets, without any limit of the jerk. The look-ahead has no "
          "end, "
          "and a part of every way is kept for constant speed. Every line must begin with its command."),
      own_settings(),
      {},
      {NC_("core", "No jerk is limited, and in corners the velocity of an axis jumps."),
       NC_("core",
           "Rapids are lines at the feed in force; those of a program that is run as it is "
           "meant run at the maximum velocity.")},
      true};
  return info;
}

Guarantees KlipperModel::guarantees(const Settings&) const {
  Guarantees promised;
  promised.meets_tangent_ends = false;
  promised.stops_at_rapids = promised.stops_at_reversals = false;
  promised.rapids_of_axes = promised.limits_jerk = false;
  promised.arcs_are_chords = true;
  promised.begins_again_at_stops = false;  // where the path turns back it stops, but plans across
  return promised;
}

ControlReading KlipperModel::do_read(const std::shared_ptr<const Toolpath>& toolpath,
                                     const Settings& settings, const Progress* progress) const {
  if (settings.text("refuse") == "off") {
    return {toolpath, {}};
  }
  const KlipperSettings limits(Machine(), settings);
  return reading_of(read_as_klipper(toolpath->source, limits, progress), *toolpath);
}

Trajectory KlipperModel::do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                                     const Settings& settings, Progress* progress) const {
  return KlipperRun(toolpath, machine, KlipperSettings(machine, settings)).run(progress);
}

Explanation KlipperModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return KlipperExplainer(motion).explain(state);
}

}  // namespace feedscope
