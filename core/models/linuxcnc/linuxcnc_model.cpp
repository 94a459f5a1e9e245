#include "core/models/linuxcnc/linuxcnc_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/limits/axis_share.h"
#include "core/machine/contour_tolerance.h"
#include "core/models/explanation/explainer.h"
#include "core/models/explanation/reason_search.h"
#include "core/models/linuxcnc/linuxcnc_run.h"
#include "core/models/linuxcnc/linuxcnc_segment.h"
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

/// The formula whose value is closer to `reached`.
Formula nearer(Formula first, Formula second, double reached) {
  const bool is_first = std::abs(first.value() - reached) <= std::abs(second.value() - reached);
  return is_first ? std::move(first) : std::move(second);
}

/// Speed of LinuxCNC on an arc, of the program or in a corner, at which sqrt(3)/2 of the acceleration is used
/// across the path, or half of that where blocks may overlap, whichever is closer to `reached` [mm/s]; none
/// for a line. `acceleration`: of the axes [mm/s2].
Formula speed_across_arc(const ElementCurve& curve, const Vec3& acceleration, double reached) {
  if (!curve.is_arc()) {
    return {};
  }
  const Vec3 normal = curve.arc.x.cross(curve.arc.y);
  const Vec3 in_plane = (Vec3::Ones() - normal.cwiseProduct(normal)).cwiseMax(0).cwiseSqrt();
  const AxisBound bound = axis_share(acceleration, in_plane);
  if (bound.axis < 0) {
    return {};
  }
  constexpr double across = linuxcnc_across_share;
  const auto with_share = [&](double share) {
    return Formula{FormulaId::shared_radial_acceleration,
                   {{Symbol::acceleration_share, -1, share},
                    {Symbol::axis_acceleration, bound.axis, acceleration[bound.axis]},
                    {Symbol::radius, -1, 1 / curve.arc.curvature()},
                    {Symbol::normal_part, bound.axis, in_plane[bound.axis]}}};
  };
  return nearer(with_share(across), with_share(across / 2), reached);
}

/// Acceleration of LinuxCNC along a line, all of it or half, whichever is closer to `reached` [mm/s2]; none
/// for an arc.
Formula acceleration_of_joints(const ElementCurve& curve, const Vec3& acceleration, double reached) {
  const AxisBound bound = axis_share(acceleration, curve.direction);
  if (curve.is_arc() || bound.axis < 0) {
    return {};
  }
  const Quantity limit{Symbol::axis_acceleration, bound.axis, acceleration[bound.axis]};
  const Quantity part{Symbol::tangent_part, bound.axis, std::abs(curve.direction[bound.axis])};
  constexpr double half = 0.5;
  return nearer({FormulaId::path_acceleration, {limit, part}},
                {FormulaId::shared_acceleration, {{Symbol::acceleration_share, -1, half}, limit, part}},
                reached);
}

/// Ramps, arcs and the blends of corners share the acceleration of the axes.
class LinuxCncExplainer : public Explainer {
 public:
  using Explainer::Explainer;

  std::string_view source_of(FormulaId id) const override {
    switch (id) {
      case FormulaId::braking_evenly:
        return "LinuxCNC, constant acceleration";
      case FormulaId::path_acceleration:
        return "LinuxCNC, MAX_ACCELERATION";
      case FormulaId::shared_acceleration:
        return "LinuxCNC, what a blend leaves of MAX_ACCELERATION";
      case FormulaId::shared_radial_acceleration:
        return "LinuxCNC, the part of MAX_ACCELERATION across an arc";
      case FormulaId::axis_velocity:
        return "LinuxCNC, MAX_VELOCITY";
      default:
        return Explainer::source_of(id);
    }
  }

 private:
  Reason reason(const State& state, Cause cause) const override {
    const bool of_arc =
        cause.kind == CauseKind::contour_tolerance || cause.kind == CauseKind::radial_acceleration;
    return of_arc || is_of_ramp(cause.kind) ? of_joints(state, cause) : Explainer::reason(state, cause);
  }

  Reason of_joints(const State& state, Cause cause) const {
    if (path().kind(state.element) == ElementKind::dwell) {
      return made(cause, {}, 0, state.element);
    }
    if (cause.kind == CauseKind::axis_acceleration) {
      const double reached = std::abs(state.tangential_acceleration);
      return made(cause, acceleration_of_joints(path().curve(state.element), axes().acceleration, reached),
                  reached, state.element);
    }
    Reason best = made(cause, {}, 0, state.element);
    look_around(state.element, farthest_of_speed, path().size(), [&](std::uint32_t element) {
      Formula formula = path().kind(element) == ElementKind::dwell
                            ? Formula()
                            : speed_across_arc(path().curve(element), axes().acceleration, state.speed);
      if (!formula.empty()) {
        best = made(cause, std::move(formula), state.speed, element);
      }
      return best.sets_it();
    });
    return best.sets_it() ? best : made(cause, {}, 0, state.element);
  }
};

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
      true};
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

Explanation LinuxCncModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return LinuxCncExplainer(motion, false).explain(state);
}

}  // namespace feedscope
