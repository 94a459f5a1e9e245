#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/feed/node_plan.h"

namespace feedscope {

/// Plans a part of a stretch separately, with its ends fixed at their largest speed: the ceiling of the
/// junction, or standstill at the ends of the stretch. As long as the nodes inside let both ends keep it, the
/// result equals that within the whole stretch, because nodes at their ceilings separate the plan. Reuses its
/// memory for all parts.
class NodePlanner {
 public:
  /// Result of a plan: done, or an end cannot keep its speed.
  enum class Outcome { planned, begin_slower, end_slower };

  /// Arguments as for plan_nodes(); they outlive the planner.
  NodePlanner(std::span<const PlanElement> elements, std::span<const SpeedBound> ceiling)
      : elements_(elements), ceiling_(ceiling) {}

  /// Plans between the first and the last of `junctions`, at least two and in order, all of which become
  /// nodes. `round`: number of rounds that found them.
  Outcome plan(std::span<const std::uint32_t> junctions, int round);
  /// `junctions` and those that must also become nodes in the first round, in order; only `junctions` if an
  /// end cannot keep its speed.
  std::vector<std::uint32_t> first_round(std::span<const std::uint32_t> junctions);
  /// Nodes of the last plan().
  const std::vector<PlanNode>& nodes() const { return nodes_; }

  /// Node for `junction` as the end of a part.
  PlanNode end_at(std::uint32_t junction) const;

 private:
  struct Gap {
    double length = 0;      ///< [mm]
    double ceiling = 0;     ///< largest of its elements [mm/s]
    double least = 0;       ///< smallest ceiling of its elements and of the junctions inside it [mm/s]
    RampLimits ramp{};      ///< smallest of its elements
    bool unchecked = true;  ///< whether its law may pass something too fast
    bool is_new = true;     ///< the speed reachable through it is not known yet
  };
  /// Speed of a node reachable from the previous nodes, and whether it has just changed.
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
  std::vector<Forward> forward_;  ///< per node
  std::vector<Gap> gaps_;         ///< between neighbouring nodes
  std::vector<std::uint32_t> found_;
};

}  // namespace feedscope
