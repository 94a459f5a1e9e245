#include "core/feed/node_plan.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/base/make_room.h"
#include "core/feed/node_planner.h"
#include "core/feed/profile_walk.h"

namespace feedscope {
namespace {

using Outcome = NodePlanner::Outcome;

/// Size of a part that is planned at once, in elements: small enough for its data to stay in a fast cache.
constexpr std::uint32_t part_elements = 1024;

/// Plans the parts of a stretch one by one. Parts end at places that probably keep their ceiling; where one
/// does not, the part is planned again together with its neighbour.
class PartsPlanner {
 public:
  PartsPlanner(std::span<const PlanElement> elements, std::span<const SpeedBound> ceiling)
      : elements_(elements), ceiling_(ceiling), planner_(elements, ceiling) {}

  std::vector<PlanNode> plan(std::span<const std::uint32_t> level) {
    std::vector<std::uint32_t> junctions{0};
    junctions.insert(junctions.end(), level.begin(), level.end());
    junctions.push_back(static_cast<std::uint32_t>(elements_.size()));
    add(std::move(junctions));
    return finish();
  }

  /// As plan_nodes_again(): between two nodes that separate the plan, only the level ones remain nodes if an
  /// element in between is `changed`, else all do.
  std::vector<PlanNode> plan_again(std::span<const std::uint32_t> level, std::span<const PlanNode> before,
                                   std::span<const std::uint32_t> changed) {
    const std::vector<Section> sections = sections_of(level, before, changed);
    const auto junctions_of = [&](std::size_t first, std::size_t last) {
      std::vector<std::uint32_t> junctions;
      for (std::size_t i = first; i < last; ++i) {
        const Section& section = sections[i];
        junctions.push_back(section.nodes.front().junction);
        if (section.changed) {
          junctions.insert(junctions.end(), section.level.begin(), section.level.end());
        } else {
          for (const PlanNode& node : section.nodes.subspan(1, section.nodes.size() - 2)) {
            junctions.push_back(node.junction);
          }
        }
      }
      junctions.push_back(sections[last - 1].nodes.back().junction);
      return junctions;
    };
    in_turn(
        sections.size(),
        [&](std::size_t first, std::size_t last) {
          if (last - first == 1 && !sections[first].changed) {
            const std::span<const PlanNode> nodes = sections[first].nodes;
            keep(nodes.first(nodes.size() - 1));
            return Outcome::planned;
          }
          return add(junctions_of(first, last));
        },
        [&](std::size_t i) { return sections[i].nodes.front().junction; });
    return finish();
  }

 private:
  /// A part of the previous plan, from one separating node to another.
  struct Section {
    std::span<const PlanNode> nodes;       ///< including both ends
    std::span<const std::uint32_t> level;  ///< junctions inside it
    bool changed = false;
  };

  std::vector<Section> sections_of(std::span<const std::uint32_t> level, std::span<const PlanNode> before,
                                   std::span<const std::uint32_t> changed) const {
    std::vector<Section> sections;
    auto change = changed.begin();
    auto next_level = level.begin();
    for (std::size_t b = 0; b + 1 < before.size();) {
      std::size_t last = b + 1;
      auto parting = next_level;
      for (; last + 1 < before.size(); ++last) {
        const PlanNode& node = before[last];
        parting = std::find_if(parting, level.end(), [&](std::uint32_t j) { return j >= node.junction; });
        if (parting != level.end() && *parting == node.junction &&
            node.speed == ceiling_[node.junction].value) {
          break;
        }
      }
      const std::uint32_t end = before[last].junction;
      const auto behind = std::find_if(change, changed.end(), [&](std::uint32_t e) { return e >= end; });
      const auto level_end = std::find_if(next_level, level.end(), [&](std::uint32_t j) { return j >= end; });
      add_section(sections, {before.subspan(b, last - b + 1), {next_level, level_end}, behind != change});
      next_level = level_end + (level_end != level.end() && *level_end == end ? 1 : 0);
      change = behind;
      b = last;
    }
    return sections;
  }

  /// Merges consecutive sections of one kind; changed ones up to the size of a part.
  static void add_section(std::vector<Section>& sections, const Section& section) {
    if (!sections.empty() && sections.back().changed == section.changed) {
      Section& before = sections.back();
      const std::uint32_t elements = section.nodes.back().junction - before.nodes.front().junction;
      if (!section.changed || elements <= part_elements) {
        before.nodes = {before.nodes.begin(), section.nodes.end()};
        before.level = {before.level.data(), section.level.data() + section.level.size()};
        return;
      }
    }
    sections.push_back(section);
  }

  /// Plans between the first and the last of `junctions` and keeps all nodes except the last.
  Outcome add(std::vector<std::uint32_t> junctions) {
    const std::uint32_t elements = junctions.back() - junctions.front();
    if (elements <= part_elements + part_elements / 2) {
      return add(junctions, 0);
    }
    int round = 0;
    if (longest_gap(junctions) > part_elements) {
      junctions = planner_.first_round(junctions);
      round = 1;
    }
    const std::vector<std::size_t> ends = ends_of_parts(junctions);
    return in_turn(
        ends.size() - 1,
        [&](std::size_t first, std::size_t last) {
          return add(std::span(junctions).subspan(ends[first], ends[last] - ends[first] + 1), round);
        },
        [&](std::size_t i) { return junctions[ends[i]]; });
  }

  Outcome add(std::span<const std::uint32_t> junctions, int round) {
    const Outcome outcome = planner_.plan(junctions, round);
    if (outcome == Outcome::planned) {
      keep(std::span(planner_.nodes()).first(planner_.nodes().size() - 1));
    }
    return outcome;
  }

  void keep(std::span<const PlanNode> nodes) {
    const double planned = std::max(part_elements, nodes.back().junction);
    make_room(nodes_, nodes.size(), std::min(1.0, planned / static_cast<double>(elements_.size())));
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  }

  static std::uint32_t longest_gap(std::span<const std::uint32_t> junctions) {
    std::uint32_t longest = 0;
    for (std::size_t i = 1; i < junctions.size(); ++i) {
      longest = std::max(longest, junctions[i] - junctions[i - 1]);
    }
    return longest;
  }

  /// Indices of the `junctions` at which parts end: about every part_elements, the slowest one nearby.
  std::vector<std::size_t> ends_of_parts(std::span<const std::uint32_t> junctions) const {
    constexpr std::uint32_t choice = part_elements / 4;
    std::vector<std::size_t> ends{0};
    std::size_t i = 1;
    while (i + 1 < junctions.size()) {
      const std::uint32_t from = junctions[ends.back()] + part_elements;
      std::size_t slowest = 0;
      for (; i + 1 < junctions.size() && junctions[i] < from; ++i) {
      }
      for (; i + 1 < junctions.size() && (slowest == 0 || junctions[i] < from + choice); ++i) {
        if (slowest == 0 || ceiling_[junctions[i]].value < ceiling_[junctions[slowest]].value) {
          slowest = i;
        }
      }
      if (slowest != 0) {
        ends.push_back(slowest);
        i = slowest + 1;
      }
    }
    ends.push_back(junctions.size() - 1);
    return ends;
  }

  /// Parts from part `first` on, and the number of nodes before them.
  struct Planned {
    std::size_t first;
    std::size_t nodes;
  };

  /// Calls plan(first, last), which keeps nodes, for parts [first, last) that cover all `count`: first for
  /// each part, then for several together if an end between two is slower. Returns whether an end of the
  /// whole is slower. `begin_of(i)`: junction at the start of part i.
  ///
  /// Cost linear in `count`: parts planned together are divided again at ends that keep their ceilings, and
  /// where none does, the part to be planned again doubles.
  template <class Plan, class BeginOf>
  Outcome in_turn(std::size_t count, const Plan& plan, const BeginOf& begin_of) {
    std::vector<Planned> planned;
    for (std::size_t first = 0; first < count;) {
      std::size_t last = first + 1;
      std::size_t kept = nodes_.size();
      for (Outcome outcome; (outcome = plan(first, last)) != Outcome::planned;) {
        nodes_.resize(kept);
        const std::size_t wanted = 2 * (last - first);
        if (outcome == Outcome::end_slower ? last == count : planned.empty()) {
          return outcome;
        }
        if (outcome == Outcome::end_slower) {
          last = std::min(count, first + wanted);
        }
        const std::size_t begin = first;
        for (; outcome == Outcome::begin_slower && !planned.empty() && last - first < wanted;
             planned.pop_back()) {
          first = planned.back().first;
          kept = planned.back().nodes;
        }
        last = std::min(count, std::max(last, first + 2 * (begin - first)));
        nodes_.resize(kept);
      }
      planned.push_back({first, kept});
      for (std::size_t i = first + 1; i < last; ++i) {
        add_parting(planned, i, begin_of(i));
      }
      first = last;
    }
    return Outcome::planned;
  }

  /// Divides the last of `planned` at the start of `part`, at `junction`, if that keeps its ceiling.
  void add_parting(std::vector<Planned>& planned, std::size_t part, std::uint32_t junction) const {
    const auto begin = nodes_.begin() + static_cast<std::ptrdiff_t>(planned.back().nodes);
    const auto node = std::lower_bound(begin, nodes_.end(), junction,
                                       [](const PlanNode& n, std::uint32_t j) { return n.junction < j; });
    if (node != nodes_.end() && node->junction == junction && node->speed == ceiling_[junction].value) {
      planned.push_back({part, static_cast<std::size_t>(node - nodes_.begin())});
    }
  }

  std::vector<PlanNode> finish() {
    nodes_.push_back(planner_.end_at(static_cast<std::uint32_t>(elements_.size())));
    return std::move(nodes_);
  }

  std::span<const PlanElement> elements_;
  std::span<const SpeedBound> ceiling_;
  NodePlanner planner_;
  std::vector<PlanNode> nodes_;
};

}  // namespace

void SpanLimits::add(const PlanElement& element) {
  length += element.length;
  ceiling = std::max(ceiling, element.speed().value);
  if (const AxisBound own = element.acceleration(); own.value < acceleration.value) {
    acceleration = own;
  }
  if (const AxisBound own = element.jerk(); own.value < jerk.value) {
    jerk = own;
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
  return PartsPlanner(elements, junction_ceiling).plan(level);
}

std::vector<PlanNode> plan_nodes_again(std::span<const PlanElement> elements,
                                       std::span<const SpeedBound> junction_ceiling,
                                       std::span<const std::uint32_t> level, std::span<const PlanNode> before,
                                       std::span<const std::uint32_t> changed) {
  return PartsPlanner(elements, junction_ceiling).plan_again(level, before, changed);
}

std::size_t first_too_fast(std::span<const PlanElement> elements,
                           std::span<const SpeedBound> junction_ceiling, std::size_t first, std::size_t last,
                           const SpeedProfile& profile) {
  ProfileWalk walk(profile);
  double s = 0;
  for (std::size_t e = first; e < last; ++e) {
    s += elements[e].length;
    const double v = walk.move_to(s).v;
    if (walk.largest_speed() > elements[e].speed().value * plan_slack ||
        (e + 1 < last && v > junction_ceiling[e + 1].value * plan_slack)) {
      return e;
    }
  }
  return last;
}

void apply_lookahead_horizon(std::span<const PlanElement> elements, std::uint32_t horizon,
                             std::span<SpeedBound> junction_ceiling) {
  // Smallest acceleration and jerk of the elements ahead, each as a queue of ascending values.
  std::deque<std::size_t> by_acceleration;
  std::deque<std::size_t> by_jerk;
  const auto push = [](std::deque<std::size_t>& queue, std::size_t e, auto value) {
    while (!queue.empty() && value(queue.back()) >= value(e)) {
      queue.pop_back();
    }
    queue.push_back(e);
  };
  const auto acceleration = [&](std::size_t e) { return elements[e].acceleration().value; };
  const auto jerk = [&](std::size_t e) { return elements[e].jerk().value; };

  std::size_t ahead = 0;
  double length = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (; ahead < elements.size() && elements[ahead].order - elements[e].order < horizon; ++ahead) {
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
