#include "core/feed/node_planner.h"

#include <algorithm>
#include <cmath>

#include "core/feed/profile_speeds.h"

namespace feedscope {
namespace {

/// Ratio up to which ceilings are equally slow: the choice of nodes must not depend on the rounding of
/// coordinates, and in short blocks a few values of curvature recur.
constexpr double equal = 1 + 1e-3;

}  // namespace

PlanNode NodePlanner::end_at(std::uint32_t junction) const {
  if (junction == 0 || junction == elements_.size()) {
    return {junction, 0, {CauseKind::exact_stop}};
  }
  return {junction, ceiling_[junction].value, ceiling_[junction].cause};
}

NodePlanner::Outcome NodePlanner::plan(std::span<const std::uint32_t> junctions, int round) {
  constexpr int careful_rounds = 24;
  begin(junctions);
  Outcome outcome = make_reachable();
  for (; outcome == Outcome::planned && any_unchecked(); ++round) {
    find_too_fast(round < careful_rounds);
    insert_found();
    outcome = make_reachable();
  }
  return outcome;
}

std::vector<std::uint32_t> NodePlanner::first_round(std::span<const std::uint32_t> junctions) {
  begin(junctions);
  found_.clear();
  if (make_reachable() == Outcome::planned) {
    find_too_fast(true);
  }
  std::vector<std::uint32_t> all(junctions.size() + found_.size());
  std::ranges::merge(junctions, found_, all.begin());
  return all;
}

void NodePlanner::begin(std::span<const std::uint32_t> junctions) {
  nodes_.clear();
  forward_.clear();
  gaps_.clear();
  for (const std::uint32_t junction : junctions) {
    if (!nodes_.empty()) {
      gaps_.push_back(gap_between(nodes_.back().junction, junction));
    }
    nodes_.push_back(end_at(junction));
    forward_.emplace_back();
  }
  forward_.front() = {nodes_.front().speed, false};
}

NodePlanner::Gap NodePlanner::gap_between(std::size_t first, std::size_t last) const {
  SpanLimits limits;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = first; e < last; ++e) {
    limits.add(elements_[e]);
    least = std::min(least, elements_[e].speed().value);
    if (e > first) {
      least = std::min(least, ceiling_[e].value);
    }
  }
  return {limits.length, limits.ceiling, least, limits.ramp()};
}

bool NodePlanner::any_unchecked() const {
  return std::ranges::any_of(gaps_, [](const Gap& gap) { return gap.unchecked; });
}

/// Fills found_ with the junctions that must become nodes, in order.
void NodePlanner::find_too_fast(bool careful) {
  found_.clear();
  for (std::size_t g = 0; g < gaps_.size(); ++g) {
    if (gaps_[g].unchecked) {
      gaps_[g].unchecked = false;
      find_too_fast(gaps_[g], nodes_[g], nodes_[g + 1], careful);
    }
  }
  found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
}

/// Of consecutive places that are too fast, takes only the slowest of a few (the first of equals) if
/// `careful`, so that ramps can still run over the others.
void NodePlanner::find_too_fast(const Gap& gap, const PlanNode& from, const PlanNode& to, bool careful) {
  constexpr std::size_t together = 8;
  const std::size_t first = from.junction;
  const std::size_t last = to.junction;
  if (last - first < 2) {
    return;
  }
  const double fastest_end = std::max(from.speed, to.speed);
  if (fastest_end <= gap.least * plan_slack &&
      !rises_above(gap.least, from.speed, to.speed, gap.length, gap.ceiling, gap.ramp)) {
    return;
  }
  const ProfileSpeeds speeds(from.speed, to.speed, gap.length, gap.ceiling, gap.ramp);
  const double fastest = speeds.largest();
  if (fastest <= gap.least * plan_slack) {
    return;
  }
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
  for (std::size_t e = first; e < last; ++e) {
    const double begin = s;
    s += elements_[e].length;
    const bool inside = speeds.is_above(elements_[e].speed().value * plan_slack, begin, s);
    const bool after = e + 1 < last && speeds.is_above(ceiling_[e + 1].value * plan_slack, s, s);
    const bool only_inside = inside && !after && !before;
    before = after;
    if (only_inside) {  // limit the element by its two ends
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

/// Backwards, so that every later node moves once and the others do not move.
void NodePlanner::insert_found() {
  std::size_t left = found_.size();
  std::size_t g = gaps_.size();
  const std::size_t count = nodes_.size() + left;
  nodes_.resize(count);
  forward_.resize(count);
  gaps_.resize(count - 1);
  while (left > 0) {
    --g;
    std::uint32_t last = nodes_[g + 1].junction;
    nodes_[g + 1 + left] = nodes_[g + 1];
    forward_[g + 1 + left] = forward_[g + 1];
    if (found_[left - 1] <= nodes_[g].junction) {
      gaps_[g + left] = gaps_[g];
      continue;
    }
    for (; left > 0 && found_[left - 1] > nodes_[g].junction; --left) {
      const std::uint32_t junction = found_[left - 1];
      gaps_[g + left] = gap_between(junction, last);
      nodes_[g + left] = end_at(junction);
      forward_[g + left] = {};
      last = junction;
    }
    gaps_[g + left] = gap_between(nodes_[g].junction, last);
  }
}

/// Sets every node to its ceiling, or to the speed reachable from its neighbours: independent of the order in
/// which the nodes were found. Recomputes only what new gaps change.
NodePlanner::Outcome NodePlanner::make_reachable() {
  const std::size_t last = gaps_.size() - 1;
  for (std::size_t g = 0; g < last; ++g) {
    Forward& after = forward_[g + 1];
    const double before = after.speed;
    if (gaps_[g].is_new || forward_[g].changed) {
      after.speed = through(g, forward_[g].speed, ceiling_[nodes_[g + 1].junction].value);
    }
    after.changed = after.speed != before;
  }
  const double end = nodes_.back().speed;
  if (through(last, forward_[last].speed, end) != end) {
    return Outcome::end_slower;
  }
  bool changed = false;  // the node after the gap
  for (std::size_t g = last; g > 0; --g) {
    changed = (gaps_[g].is_new || changed || forward_[g].changed) && settle(g);
    gaps_[g].is_new = forward_[g].changed = false;
  }
  gaps_[0].is_new = false;
  const double begin = nodes_.front().speed;
  return through(0, nodes_[1].speed, begin) == begin ? Outcome::planned : Outcome::begin_slower;
}

/// Sets node `g` from the next one; returns whether that changes it.
bool NodePlanner::settle(std::size_t g) {
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

/// Speed, at most `wanted`, reachable through gap `g` from `other` at its far end.
double NodePlanner::through(std::size_t g, double other, double wanted) const {
  const double length = gaps_[g].length;
  const RampLimits ramp = gaps_[g].ramp;
  if (wanted <= other || ramp_length(other, wanted, ramp) <= length) {
    return wanted;
  }
  return std::min(wanted, reachable_speed(other, length, ramp));
}

}  // namespace feedscope
