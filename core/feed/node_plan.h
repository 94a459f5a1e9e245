#pragma once

// Room `feed`: speeds within the ceilings. NodePlanner plans a stretch between two standstills with
// look-ahead, node by node; ramp.h is the jerk-limited change of speed between two nodes, profile_walk.h its
// course.

#include <cstdint>
#include <span>
#include <vector>

#include "core/feed/ramp.h"
#include "core/limits/segment_limits.h"

namespace feedscope {

/// Factor by which rounding may raise the planned speed above a ceiling.
inline constexpr double plan_slack = 1 + 1e-7;

/// One element of a stretch between two standstills, for planning: 40 bytes.
class PlanElement {
 public:
  PlanElement() = default;
  /// `limits`: ceiling over the whole element, and ramps along it.
  PlanElement(double length, const MotionLimits& limits) : length(length) { set_limits(limits); }

  SpeedBound speed() const { return {speed_, speed_cause_}; }
  AxisBound acceleration() const {
    const bool by_jerk = acceleration_axis_ >= by_jerk_from;
    return {acceleration_, static_cast<std::int8_t>(acceleration_axis_ - (by_jerk ? by_jerk_step : 0)),
            by_jerk};
  }
  AxisBound jerk() const { return {jerk_, jerk_axis_}; }
  MotionLimits limits() const { return {speed(), acceleration(), jerk()}; }
  void set_limits(const MotionLimits& limits) {
    speed_ = limits.speed.value;
    speed_cause_ = limits.speed.cause;
    set_ramps(limits.acceleration, limits.jerk);
  }
  void set_ramps(const AxisBound& acceleration, const AxisBound& jerk) {
    acceleration_ = acceleration.value;
    acceleration_axis_ =
        static_cast<std::int8_t>(acceleration.axis + (acceleration.by_jerk ? by_jerk_step : 0));
    jerk_ = jerk.value;
    jerk_axis_ = jerk.axis;
  }

  double length = 0;        ///< > 0 [mm]
  std::uint32_t order = 0;  ///< number of the block for the look-ahead

 private:
  /// Encodes AxisBound::by_jerk in the axis number.
  static constexpr std::int8_t by_jerk_step = 64;
  static constexpr std::int8_t by_jerk_from = by_jerk_step - 1;  // no axis

  Cause speed_cause_;
  std::int8_t acceleration_axis_ = -1;  ///< plus by_jerk_step if limited by its jerk
  std::int8_t jerk_axis_ = -1;
  double speed_ = 0;
  double acceleration_ = 0;
  double jerk_ = 0;
};

/// A junction with its planned speed and zero acceleration.
struct PlanNode {
  std::uint32_t junction = 0;  ///< before element `junction`; elements.size() is the end
  double speed = 0;            ///< [mm/s]
  Cause cause;                 ///< the junction itself, or the slower place after it that determines it
};

/// Limits of ramps over elements [first, last): the smallest of each.
struct SpanLimits {
  double length = 0;   ///< [mm]
  double ceiling = 0;  ///< largest speed ceiling of them [mm/s]
  AxisBound acceleration{std::numeric_limits<double>::infinity(), -1};
  AxisBound jerk{std::numeric_limits<double>::infinity(), -1};

  RampLimits ramp() const { return {acceleration.value, jerk.value}; }
  void add(const PlanElement& element);
};
SpanLimits span_limits(std::span<const PlanElement> elements, std::size_t first, std::size_t last);

/// Plans junction speeds from standstill to standstill, with ramps over many short elements.
///
///   speed ^        ceiling ---.      .--------
///         |   nodes o    .-o  |_o__o_|  .-o    Between neighbouring nodes the law is plan_profile();
///         |        /      \     ....            every element keeps its ceiling, every junction its own.
///         +------------------------------- path
///
/// Starts with the two standstills, adds the slowest places that the law in between passes too fast, sets
/// every node to the speed reachable from its neighbours, and repeats until nothing is too fast.
/// `junction_ceiling`: elements.size() + 1 values, of which the first and last count as 0 [mm/s]. `level`:
/// inner junctions, in order, that are nodes at any speed. Cost linear in the number of elements: a bounded
/// number of passes. Long stretches are planned part by part, with the same result.
std::vector<PlanNode> plan_nodes(std::span<const PlanElement> elements,
                                 std::span<const SpeedBound> junction_ceiling,
                                 std::span<const std::uint32_t> level = {});

/// Plans again, given a plan `before` of the same elements and ceilings of which only the limits of elements
/// `changed`, in order, and neighbouring level junctions are different: sections between level nodes at their
/// ceilings are planned again if something in them is changed.
std::vector<PlanNode> plan_nodes_again(std::span<const PlanElement> elements,
                                       std::span<const SpeedBound> junction_ceiling,
                                       std::span<const std::uint32_t> level, std::span<const PlanNode> before,
                                       std::span<const std::uint32_t> changed);

/// Lowers `junction_ceiling` so that standstill is possible within `horizon` blocks from every junction, by
/// the `order` of the elements: the look-ahead of core/models/README.md.
void apply_lookahead_horizon(std::span<const PlanElement> elements, std::uint32_t horizon,
                             std::span<SpeedBound> junction_ceiling);

/// First element or junction of [first, last) that `profile` passes too fast; `last` if there is none.
std::size_t first_too_fast(std::span<const PlanElement> elements,
                           std::span<const SpeedBound> junction_ceiling, std::size_t first, std::size_t last,
                           const SpeedProfile& profile);

}  // namespace feedscope
