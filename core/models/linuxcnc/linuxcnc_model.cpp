#include "core/models/linuxcnc/linuxcnc_model.h"

#include <algorithm>
#include <limits>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/limits/axis_share.h"
#include "core/machine/contour_tolerance.h"
#include "core/models/linuxcnc/linuxcnc_run.h"
#include "core/models/linuxcnc/linuxcnc_words.h"

namespace feedscope {
namespace {

std::vector<SettingSpec> linuxcnc_settings() {
  std::vector<SettingSpec> specs{
      {
          .key = "planner",
          .title = QT_TRANSLATE_NOOP("core", "Planner"),
          .explanation = QT_TRANSLATE_NOOP(
              "core",
              "Version of LinuxCNC. 2.9 gives the last move of a program and one that stands "
              "alone half of the acceleration under G64; master gives them all of it, but "
              "limits arcs more."),
          .choices = {"2.9", "master"},
      },
      {
          .key = "blend_mode",
          .title = QT_TRANSLATE_NOOP("core", "Path control mode"),
          .explanation = QT_TRANSLATE_NOOP(
              "core",
              "Where the program gives none: G64 blends corners within the blend tolerance, "
              "G61 stops where blocks do not join tangentially, G61.1 at the end of every "
              "block."),
          .choices = {"G64", "G61", "G61.1"},
      },
      {
          .key = blend_tolerance_key,
          .title = QT_TRANSLATE_NOOP("core", "Blend tolerance"),
          .unit = "mm",
          .explanation =
              QT_TRANSLATE_NOOP("core",
                                "P of G64 where the program gives none: how far blends may leave the corner. "
                                "0: as far as a quarter of the blocks, as fast as possible."),
          .maximum = 100,
      },
      {
          .key = "naive_tolerance_mm",
          .title = QT_TRANSLATE_NOOP("core", "Naive CAM tolerance"),
          .unit = "mm",
          .explanation =
              QT_TRANSLATE_NOOP("core",
                                "Q of G64 where the program gives none: blocks whose ends lie within it of a "
                                "line become one block. 0: none do. Without a value the blend tolerance."),
          .maximum = 100,
          .optional = true,
      },
      {
          .key = "servo_period_s",
          .title = QT_TRANSLATE_NOOP("core", "Servo period"),
          .unit = "s",
          .explanation =
              QT_TRANSLATE_NOOP("core",
                                "SERVO_PERIOD: time of one step of the planner, which takes one block at "
                                "most from the program in each."),
          .minimum = 1e-5,
          .maximum = 0.1,
          .fallback = 1e-3,
      },
      {
          .key = "max_linear_velocity_m_min",
          .title = QT_TRANSLATE_NOOP("core", "Maximum linear velocity"),
          .unit = "m/min",
          .explanation =
              QT_TRANSLATE_NOOP("core",
                                "MAX_LINEAR_VELOCITY: of the tool along the path. Without a value only the "
                                "axes limit it."),
          .minimum = 1e-6,
          .maximum = 1e9,
          .optional = true,
      },
      {
          .key = "max_feed_override",
          .title = QT_TRANSLATE_NOOP("core", "Maximum feed override"),
          .explanation =
              QT_TRANSLATE_NOOP("core",
                                "MAX_FEED_OVERRIDE: up to where the operator may raise the feed; blends are "
                                "laid for that speed. The program runs at 100 %."),
          .minimum = 1,
          .maximum = 10,
          .fallback = 1,
      },
  };
  return specs;
}

LinuxCncPathMode path_mode_of(std::string_view code) {
  if (code == "G61") {
    return LinuxCncPathMode::exact_path;
  }
  return code == "G61.1" ? LinuxCncPathMode::exact_stop : LinuxCncPathMode::blend;
}

}  // namespace

LinuxCncSettings::LinuxCncSettings(const Machine& machine, const Settings& settings)
    : velocity(axis_limit_vector(machine, &AxisLimits::velocity)),
      acceleration(axis_limit_vector(machine, &AxisLimits::acceleration)),
      period(settings.number("servo_period_s")),
      max_velocity(std::numeric_limits<double>::infinity()),
      max_override(settings.number("max_feed_override")),
      master(settings.text("planner") == "master"),
      path_mode(path_mode_of(settings.text("blend_mode"))),
      blend_tolerance(settings.number(blend_tolerance_key)),
      naive_tolerance(blend_tolerance),
      follows_program(follows_program_tolerance(settings)) {
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    turn_velocity[rotary_names.find(axis.name)] = axis.velocity;
    turn_acceleration[rotary_names.find(axis.name)] = axis.acceleration;
  }
  if (settings.has("max_linear_velocity_m_min")) {
    max_velocity = units::from_m_min(settings.number("max_linear_velocity_m_min"));
  }
  if (settings.has("naive_tolerance_mm")) {
    naive_tolerance = settings.number("naive_tolerance_mm");
    own_naive_tolerance = true;
  }
}

const ModelInfo& LinuxCncModel::info() const {
  static const ModelInfo info{
      "linuxcnc",
      QT_TRANSLATE_NOOP("core", "Open control LinuxCNC"),
      "LinuxCNC 2.9 and master, rebuilt from a description of their planner and compared with results of "
      "their own code",
      QT_TRANSLATE_NOOP(
          "core",
          "Every servo period the planner computes the next place, with constant acceleration and no limit "
          "of the jerk. Under G64 arcs within the tolerance blend corners, or neighbours overlap, and short "
          "blocks along a line become one; under G61 corners are exact stops. Half of the acceleration is "
          "kept back for blends."),
      linuxcnc_settings(),
      {program_tolerance_key},
      {NC_("core",
           "No jerk is limited, and where blocks meet within a small kink the velocity of an axis jumps."),
       NC_("core",
           "The time runs from the first to the last motion: a dwell before or after all of "
           "it is not counted."),
       NC_("core", "Rapids blend among each other; next to a feed motion they stop.")},
      {.jumps_in_corners = true,
       .joints_take_acceleration = true,
       .sources = {
           {FormulaId::braking_evenly, "LinuxCNC, constant acceleration"},
           {FormulaId::path_acceleration, "LinuxCNC, MAX_ACCELERATION"},
           {FormulaId::shared_acceleration, "LinuxCNC, what a blend leaves of MAX_ACCELERATION"},
           {FormulaId::shared_radial_acceleration, "LinuxCNC, the part of MAX_ACCELERATION across an arc"},
           {FormulaId::axis_velocity, "LinuxCNC, MAX_VELOCITY"}}}};
  return info;
}

Guarantees LinuxCncModel::guarantees(const Settings& /*settings*/) const {
  Guarantees promised;
  promised.feed = Guarantees::unbounded;     // speeds of two overlapping segments add
  promised.contour = Guarantees::unbounded;  // without P up to a quarter of the blocks, and lines are joined
  promised.meets_tangent_ends = false;
  promised.follows_compaction = promised.own_tolerances = true;
  promised.begins_again_at_stops = false;
  promised.continuity = Continuity::position;
  promised.limits_jerk = false;
  promised.stops_at_rapids = promised.stops_at_reversals = false;
  return promised;
}

std::vector<const char*> LinuxCncModel::left_out(const Toolpath& path, const Settings& /*settings*/) const {
  std::vector<const char*> notes;
  const auto turns_alone = [&](const Segment& segment) {
    return segment.kind == SegmentKind::dwell && path.pause_of(segment).kind == Pause::indexing;
  };
  if (std::ranges::any_of(path.segments, turns_alone)) {
    notes.push_back(
        QT_TRANSLATE_NOOP("core",
                          "Blocks in which rotary axes turn alone are run from stop to stop; under "
                          "G64 the control overlaps them with their neighbours, which saves up to "
                          "0.4 s each."));
  }
  if (path.source != nullptr && switches_coolant(*path.source)) {
    notes.push_back(QT_TRANSLATE_NOOP("core",
                                      "At M7, M8 and M9 the control waits for its coolant, often 0.1 s each "
                                      "time: not in the cycle time."));
  }
  return notes;
}

Trajectory LinuxCncModel::do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                                      const Settings& settings, Progress* progress) const {
  return LinuxCncRun(toolpath, machine, LinuxCncSettings(machine, settings)).run(progress);
}

}  // namespace feedscope
