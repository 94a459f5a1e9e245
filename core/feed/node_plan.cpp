#include "core/feed/node_plan.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/feed/profile_walk.h"

namespace feedscope {
namespace {

constexpr double slack = 1 + 1e-7;
/// Places whose ceilings differ by less are equally slow: which of them becomes a node must not depend on
/// the rounding of coordinates, and in short blocks curvatures of a few values come again and again.
constexpr double equal = 1 + 1e-3;

/// Nodes, and per gap between neighbours its limits and whether it still has to be checked.
class NodePlanner {
 public:
  NodePlanner(std::span<const PlanElement> elements, std::span<const SpeedBound> ceiling,
              std::span<const std::uint32_t> level)
      : elements_(elements), ceiling_(ceiling), found_(level.begin(), level.end()) {
    const Cause rest{CauseKind::exact_stop};
    nodes_ = {{0, 0, rest}, {static_cast<std::uint32_t>(elements.size()), 0, rest}};
    forward_ = {{0, false}, {0, false}};
    gaps_ = {gap_between(0, elements.size())};
    insert_found();
    make_reachable();
  }

  /// Begins with the nodes of `before`. Of those between two level ones at their ceilings, which part what
  /// lies before from what lies behind, the level ones alone stay if an element is `changed` there.
  NodePlanner(std::span<const PlanElement> elements, std::span<const SpeedBound> ceiling,
              std::span<const std::uint32_t> level, std::span<const PlanNode> before,
              std::span<const std::uint32_t> changed)
      : elements_(elements), ceiling_(ceiling), nodes_{before.front()}, forward_{{0, false}} {
    auto change = changed.begin();
    auto next_level = level.begin();
    auto parting = level.begin();
    for (std::size_t b = 1; b < before.size();) {
      // To the next node that parts: `last` of `before`, or its end.
      std::size_t last = b;
      for (; last + 1 < before.size(); ++last) {
        const PlanNode& node = before[last];
        parting = std::find_if(parting, level.end(), [&](std::uint32_t j) { return j >= node.junction; });
        if (parting != level.end() && *parting == node.junction &&
            node.speed == ceiling[node.junction].value) {
          break;
        }
      }
      const std::uint32_t end = before[last].junction;
      const auto behind = std::find_if(change, changed.end(), [&](std::uint32_t e) { return e >= end; });
      if (behind == change) {
        for (; b <= last; ++b) {
          append(before[b], false);
        }
        next_level = std::find_if(next_level, level.end(), [&](std::uint32_t j) { return j > end; });
      } else {
        for (; next_level != level.end() && *next_level < end; ++next_level) {
          append({*next_level, ceiling[*next_level].value, ceiling[*next_level].cause}, true);
        }
        append(before[last], true);
        next_level += next_level != level.end() && *next_level == end ? 1 : 0;
        b = last + 1;
      }
      change = behind;
    }
    forward_.back() = {0, false};
    make_reachable();
  }

  std::vector<PlanNode> plan() {
    constexpr int careful_rounds = 24;
    for (int round = 0; any_unchecked(); ++round) {
      find_too_fast(round < careful_rounds);
      insert_found();
      make_reachable();
    }
    return std::move(nodes_);
  }

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

  void append(const PlanNode& node, bool unchecked) {
    gaps_.push_back(gap_between(nodes_.back().junction, node.junction));
    gaps_.back().unchecked = unchecked;
    nodes_.push_back(node);
    forward_.emplace_back();
  }

  Gap gap_between(std::size_t first, std::size_t last) const {
    SpanLimits limits;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t e = first; e < last; ++e) {
      limits.add(elements_[e]);
      least = std::min(least, elements_[e].limits.speed.value);
      if (e > first) {
        least = std::min(least, ceiling_[e].value);
      }
    }
    return {limits.length, limits.ceiling, least, limits.ramp()};
  }

  bool any_unchecked() const {
    return std::any_of(gaps_.begin(), gaps_.end(), [](const Gap& gap) { return gap.unchecked; });
  }

  /// Fills found_ with junctions that have to become nodes, in order. Of neighbouring places that are too
  /// fast only the slowest of a few, the first of equals, does when `careful`, so that ramps still run over
  /// the others.
  void find_too_fast(bool careful) {
    constexpr std::size_t together = 8;
    found_.clear();
    for (std::size_t g = 0; g < gaps_.size(); ++g) {
      if (!gaps_[g].unchecked) {
        continue;
      }
      gaps_[g].unchecked = false;
      const std::size_t first = nodes_[g].junction;
      const std::size_t last = nodes_[g + 1].junction;
      if (last - first < 2) {
        continue;
      }
      const SpeedProfile profile = plan_profile(nodes_[g].speed, 0, nodes_[g + 1].speed, gaps_[g].length,
                                                gaps_[g].ceiling, gaps_[g].ramp);
      const double fastest = std::max({nodes_[g].speed, nodes_[g + 1].speed, profile.peak});
      if (fastest <= gaps_[g].least * slack) {
        continue;
      }
      ProfileWalk walk(profile);
      double s = 0;
      std::size_t slowest = last;
      std::size_t run = 0;
      bool before = false;  // the junction before the element is passed too fast
      const auto take = [&] {
        if (slowest != last) {
          found_.push_back(static_cast<std::uint32_t>(slowest));
        }
        slowest = last;
        run = 0;
      };
      bool behind = false;  // the walk, where nothing can be too fast
      for (std::size_t e = first; e < last; ++e) {
        if (fastest <= elements_[e].limits.speed.value * slack &&
            (e + 1 == last || fastest <= ceiling_[e + 1].value * slack)) {
          s += elements_[e].length;
          behind = true;
          before = false;
          take();
          continue;
        }
        if (behind) {
          walk.move_to(s);
          behind = false;
        }
        s += elements_[e].length;
        const double v = walk.move_to(s).v;
        const bool inside = walk.largest_speed() > elements_[e].limits.speed.value * slack;
        const bool after = e + 1 < last && v > ceiling_[e + 1].value * slack;
        const bool only_inside = inside && !after && !before;
        before = after;
        if (only_inside) {  // hold the element by its two ends
          take();
          if (e > first) {
            found_.push_back(static_cast<std::uint32_t>(e));
          }
          if (e + 1 < last) {
            found_.push_back(static_cast<std::uint32_t>(e + 1));
          }
          continue;
        }
        if (!after) {
          take();
          continue;
        }
        if (slowest == last || ceiling_[e + 1].value * equal < ceiling_[slowest].value) {
          slowest = e + 1;
        }
        if (++run == together || !careful) {
          take();
        }
      }
      take();
    }
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
  }

  /// From the back, so that every node behind moves once and the others not at all.
  void insert_found() {
    std::size_t left = found_.size();
    std::size_t g = gaps_.size();
    // Exactly what is needed: the rounds are few, and room for twice as many is the peak of a simulation.
    const std::size_t count = nodes_.size() + left;
    nodes_.reserve(count);
    forward_.reserve(count);
    gaps_.reserve(count - 1);
    nodes_.resize(count);
    forward_.resize(count);
    gaps_.resize(count - 1);
    while (left > 0) {
      --g;
      std::size_t last = nodes_[g + 1].junction;
      nodes_[g + 1 + left] = nodes_[g + 1];
      forward_[g + 1 + left] = forward_[g + 1];
      if (found_[left - 1] <= nodes_[g].junction) {
        gaps_[g + left] = gaps_[g];
        continue;
      }
      for (; left > 0 && found_[left - 1] > nodes_[g].junction; --left) {
        const std::uint32_t junction = found_[left - 1];
        gaps_[g + left] = gap_between(junction, last);
        nodes_[g + left] = {junction, ceiling_[junction].value, ceiling_[junction].cause};
        forward_[g + left] = {};
        last = junction;
      }
      gaps_[g + left] = gap_between(nodes_[g].junction, last);
    }
  }

  /// Every node to its ceiling, or to what its neighbours let it reach: the same whatever order the nodes
  /// were found in. Only what new gaps change is computed again.
  void make_reachable() {
    for (std::size_t g = 0; g + 1 < gaps_.size(); ++g) {
      Forward& after = forward_[g + 1];
      const double before = after.speed;
      if (gaps_[g].is_new || forward_[g].changed) {
        after.speed = through(g, forward_[g].speed, ceiling_[nodes_[g + 1].junction].value);
      }
      after.changed = after.speed != before;
    }
    bool changed = false;  // the node behind the gap
    for (std::size_t g = gaps_.size(); g-- > 1;) {
      changed = (gaps_[g].is_new || changed || forward_[g].changed) && settle(g);
      gaps_[g].is_new = forward_[g].changed = false;
    }
    gaps_[0].is_new = false;
  }

  /// Sets node `g` by the one behind it; whether that changes it.
  bool settle(std::size_t g) {
    PlanNode& node = nodes_[g];
    const PlanNode before = node;
    const double reach = through(g, nodes_[g + 1].speed, forward_[g].speed);
    node.cause = reach < forward_[g].speed ? nodes_[g + 1].cause : ceiling_[node.junction].cause;
    node.speed = reach;
    if (node.speed != before.speed) {
      gaps_[g - 1].unchecked = gaps_[g].unchecked = true;
    }
    return node.speed != before.speed || node.cause != before.cause;
  }

  /// The speed, at most `wanted`, that gap `g` lets reach from `other` at its far end.
  double through(std::size_t g, double other, double wanted) const {
    const double length = gaps_[g].length;
    const RampLimits ramp = gaps_[g].ramp;
    if (wanted <= other || ramp_length(other, wanted, ramp) <= length) {
      return wanted;
    }
    return std::min(wanted, reachable_speed(other, length, ramp));
  }

  std::span<const PlanElement> elements_;
  std::span<const SpeedBound> ceiling_;
  std::vector<PlanNode> nodes_;
  std::vector<Forward> forward_;  ///< a node
  std::vector<Gap> gaps_;
  std::vector<std::uint32_t> found_;
};

}  // namespace

void SpanLimits::add(const PlanElement& element) {
  length += element.length;
  ceiling = std::max(ceiling, element.limits.speed.value);
  if (element.limits.acceleration.value < acceleration.value) {
    acceleration = element.limits.acceleration;
  }
  if (element.limits.jerk.value < jerk.value) {
    jerk = element.limits.jerk;
  }
}

SpanLimits span_limits(std::span<const PlanElement> elements, std::size_t first, std::size_t last) {
  SpanLimits limits;
  for (std::size_t e = first; e < last; ++e) {
    limits.add(elements[e]);
  }
  return limits;
}

std::vector<PlanNode> plan_nodes(std::span<const PlanElement> elements,
                                 std::span<const SpeedBound> junction_ceiling,
                                 std::span<const std::uint32_t> level) {
  return NodePlanner(elements, junction_ceiling, level).plan();
}

std::vector<PlanNode> plan_nodes_again(std::span<const PlanElement> elements,
                                       std::span<const SpeedBound> junction_ceiling,
                                       std::span<const std::uint32_t> level, std::span<const PlanNode> before,
                                       std::span<const std::uint32_t> changed) {
  return NodePlanner(elements, junction_ceiling, level, before, changed).plan();
}

std::size_t first_too_fast(std::span<const PlanElement> elements,
                           std::span<const SpeedBound> junction_ceiling, std::size_t first, std::size_t last,
                           const SpeedProfile& profile) {
  ProfileWalk walk(profile);
  double s = 0;
  for (std::size_t e = first; e < last; ++e) {
    s += elements[e].length;
    const double v = walk.move_to(s).v;
    if (walk.largest_speed() > elements[e].limits.speed.value * slack ||
        (e + 1 < last && v > junction_ceiling[e + 1].value * slack)) {
      return e;
    }
  }
  return last;
}

void apply_lookahead_horizon(std::span<const PlanElement> elements, std::span<const std::uint32_t> block_of,
                             std::uint32_t horizon, std::span<SpeedBound> junction_ceiling) {
  // Least acceleration and jerk of the elements ahead, each by a queue of rising values.
  std::deque<std::size_t> by_acceleration;
  std::deque<std::size_t> by_jerk;
  const auto push = [](std::deque<std::size_t>& queue, std::size_t e, auto value) {
    while (!queue.empty() && value(queue.back()) >= value(e)) {
      queue.pop_back();
    }
    queue.push_back(e);
  };
  const auto acceleration = [&](std::size_t e) { return elements[e].limits.acceleration.value; };
  const auto jerk = [&](std::size_t e) { return elements[e].limits.jerk.value; };

  std::size_t ahead = 0;
  double length = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (; ahead < elements.size() && block_of[ahead] - block_of[e] < horizon; ++ahead) {
      push(by_acceleration, ahead, acceleration);
      push(by_jerk, ahead, jerk);
      length += elements[ahead].length;
    }
    while (by_acceleration.front() < e) {
      by_acceleration.pop_front();
    }
    while (by_jerk.front() < e) {
      by_jerk.pop_front();
    }
    const RampLimits ramp{acceleration(by_acceleration.front()), jerk(by_jerk.front())};
    if (ahead < elements.size() && ramp_length(0, junction_ceiling[e].value, ramp) > length) {
      junction_ceiling[e].lower(reachable_speed(0, length, ramp), {CauseKind::lookahead_horizon});
    }
    length -= elements[e].length;
  }
}

}  // namespace feedscope
