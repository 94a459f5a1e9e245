#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/blend/path_rules.h"
#include "core/feed/node_plan.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// Part of the path from standstill to standstill, as models plan and run it. Arrays by element; reused from
/// stretch to stretch to avoid allocations.
struct Stretch {
  std::vector<PlanElement> plan;
  std::vector<std::uint8_t> blend;     ///< 1: a corner blend, whose speed the model itself sets
  std::vector<SpeedBound> ceiling;     ///< at the plan.size() + 1 junctions [mm/s]
  std::vector<std::uint32_t> level;    ///< junctions of level places, which are always nodes of the plan
  std::vector<std::uint32_t> turning;  ///< the same, by part_turning()
  /// Blends are planned and run by their own parameter u: their path length in the plan is u times the
  /// blend's planned length, which is |dS/du| at both of its ends, so that the speed is continuous there.
  bool blends_by_parameter = false;
  bool has_curves = false;  ///< contains spans of smooth curves

  void clear();
  /// Reserves room for that many elements, so that long stretches are not copied while they grow.
  void reserve(std::size_t elements);
  /// Adds the next element of the path. `block`: block of the path to which it belongs, as counted by a
  /// look-ahead.
  void add(const PlanElement& planned, std::uint32_t path_element, std::uint32_t block,
           bool is_blend = false);
  /// The same for a span of a smooth curve, which counts as a block of its own.
  void add_span(const PlanElement& planned, std::uint32_t path_element, std::uint32_t block);

  /// Index of element `e` in the path.
  std::uint32_t element(std::size_t e) const { return first_element_ + static_cast<std::uint32_t>(e); }

  /// Makes element `e` a level place of the plan: one speed at both of its ends. Call in order of e, after
  /// set_junction_ceilings().
  void hold_level(std::uint32_t e);
  /// All junctions that are always nodes of the plan, in order; valid until the next call.
  std::span<const std::uint32_t> held();
  bool is_level(std::size_t e) const { return plan[e].jerk().value == no_ramp; }
  bool by_parameter(std::size_t e) const { return blends_by_parameter && blend[e] != 0; }

  static constexpr double no_ramp = 1e-12;  ///< limits of a level element [mm/s2, mm/s3]

 private:
  std::uint32_t first_element_ = 0;
  std::uint32_t last_block_ = 0;     ///< of the element added last
  std::vector<std::uint32_t> held_;  ///< level and turning ones
};

/// Segments [first, last) from standstill to standstill.
struct StretchRange {
  std::size_t first = 0;
  std::size_t last = 0;
};
/// Stretch that begins at segment `first`: up to the next stop or corner without any tolerance and, if
/// `stop_at_arc_corners`, up to the next corner at an arc. A dwell is a stretch of its own.
StretchRange next_stretch(const Toolpath& toolpath, const PathRules& rules, std::size_t first,
                          bool stop_at_arc_corners = true);

/// Runs a model on a stretch of lines and arcs; `steps` counts segments.
using StretchRun = std::function<void(const StretchRange& range, ProgressSteps& steps)>;
/// Makes the StretchRun that fills `builder`, for one thread.
using StretchRunner = std::function<StretchRun(TrajectoryBuilder& builder)>;
/// Runs every stretch, cut as by next_stretch(), and lays the dwells between them. Long programs are run in
/// parts on several cores, each with its own runner. The cuts depend on the program alone, so that the result
/// does not depend on the number of cores.
void run_stretches(const Toolpath& toolpath, TrajectoryBuilder& builder, Progress* progress,
                   const PathRules& rules, const StretchRunner& runner, bool stop_at_arc_corners = true);

/// Sets the ramps of the stretch where the program is in BRISK (with_acceleration_jumps() of
/// segment_limits.h), on corner pieces where both segments are. Call before set_junction_ceilings().
void follow_acceleration_mode(Stretch& stretch, const BlendedPath& path, const PathRules& rules,
                              double interpolation_period);

/// Sets stretch.ceiling: the lower ceiling of the two elements at each junction; crossing_speed() where
/// programmed segments meet in a tangent junction without a blend; turn_ceiling(); the look-ahead horizon; 0
/// at both ends.
void set_junction_ceilings(Stretch& stretch, const BlendedPath& path, const Vec3& axis_jerk,
                           double interpolation_period, std::uint32_t lookahead_blocks);

/// Sets stretch.turning: junctions where the ramps that rotary axes allow have become twice as slow or fast
/// as at the junction before. A ramp takes the least limits of all its elements, and near a singular position
/// those of a few blocks are a hundredth of those farther away. Empty where no rotary axis turns.
void part_turning(Stretch& stretch, const BlendedPath& path);

/// plan_profile over `span` from (speed, acceleration) to (target, 0); where the span is too short for
/// `target`, to the highest reachable speed.
SpeedProfile profile_to(double target, const SpanLimits& span, double speed, double acceleration);

/// Lays `profile` over elements [first, last) of the stretch as pieces by path length. `slower_place`: cause
/// of the speed to which it slows down. Returns the speed at its end [mm/s].
double add_profile(TrajectoryBuilder& builder, const Stretch& stretch, const SpeedProfile& profile,
                   const SpanLimits& span, std::size_t first, std::size_t last, Cause slower_place);

/// Lays the jerk-limited law from node to node over the whole stretch, from rest to rest; level elements at
/// constant speed.
void add_planned_motion(TrajectoryBuilder& builder, const Stretch& stretch,
                        const std::vector<PlanNode>& nodes, ProgressSteps& steps);

}  // namespace feedscope
