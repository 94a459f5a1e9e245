#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/feed/node_plan.h"

namespace feedscope {

/// Plans a part of a stretch by itself, its ends held at the speed that they may have: the ceiling of the
/// junction, or standstill at the ends of the stretch. As long as the nodes inside let both ends keep it, the
/// part is planned as it would be within the whole stretch, because ends at their ceilings part what lies
/// before from what lies behind. Keeps its room from part to part.
class NodePlanner {
 public:
  /// What a plan has come to: done, or an end cannot keep its speed.
  enum class Outcome { planned, begin_slower, end_slower };

  /// As of plan_nodes(); they outlive the planner.
  NodePlanner(std::span<const PlanElement> elements, std::span<const SpeedBound> ceiling)
      : elements_(elements), ceiling_(ceiling) {}

  /// Plans between the first and the last of `junctions`, at least two and in order, all of which become
  /// nodes. `round`: how many rounds have found them.
  Outcome plan(std::span<const std::uint32_t> junctions, int round);
  /// `junctions` and those that have to become nodes besides in the first round, in order; themselves where
  /// an end cannot keep its speed.
  std::vector<std::uint32_t> first_round(std::span<const std::uint32_t> junctions);
  /// The nodes of the last plan().
  const std::vector<PlanNode>& nodes() const { return nodes_; }

  /// The node that `junction` is as the end of a part.
  PlanNode end_at(std::uint32_t junction) const;

 private:
  struct Gap {
    double length = 0;      ///< [mm]
    double ceiling = 0;     ///< highest of its elements [mm/s]
    double least = 0;       ///< ceiling of its elements and of the junctions inside it [mm/s]
    RampLimits ramp{};      ///< least of its elements
    bool unchecked = true;  ///< whether the law in it passes something too fast
    bool is_new = true;     ///< what can be reached through it is not known yet
  };
  /// Of a node: the speed that can be reached from the nodes before it, and whether it has just changed.
  struct Forward {
    double speed = std::numeric_limits<double>::quiet_NaN();
    bool changed = true;
  };

  void begin(std::span<const std::uint32_t> junctions);
  Gap gap_between(std::size_t first, std::size_t last) const;
  bool any_unchecked() const;
  void find_too_fast(bool careful);
  void find_too_fast(const Gap& gap, const PlanNode& from, const PlanNode& to, bool careful);
  void insert_found();
  Outcome make_reachable();
  bool settle(std::size_t g);
  double through(std::size_t g, double other, double wanted) const;

  std::span<const PlanElement> elements_;
  std::span<const SpeedBound> ceiling_;
  std::vector<PlanNode> nodes_;
  std::vector<Forward> forward_;  ///< a node
  std::vector<Gap> gaps_;         ///< between neighbouring nodes
  std::vector<std::uint32_t> found_;
};

}  // namespace feedscope
