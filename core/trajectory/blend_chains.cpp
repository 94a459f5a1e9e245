#include "core/trajectory/blend_chains.h"

#include <algorithm>
#include <cmath>

#include "core/feed/profile_speeds.h"

namespace feedscope {
namespace {

/// Steps of a plan: the step of ramps that each element has reached, and whether ramps over blends also run
/// over the short lines between them.
struct Steps {
  static constexpr std::uint8_t level = std::tuple_size_v<BlendRamps>;  ///< of elements at one speed
  static constexpr std::uint8_t separate = level + 1;                   ///< of a line on its own

  std::vector<std::uint8_t> of;  ///< by element
  bool lines_join = true;
};

class BlendChains {
 public:
  BlendChains(Stretch& stretch, const RampsOfBlend& ramps_of, const std::function<void()>& stop)
      : stretch_(stretch),
        plan_(stretch.plan),
        stop_(stop),
        chains_{std::vector(stretch.plan.size(), Steps::level)} {
    const std::size_t count = plan_.size();
    blend_.resize(count);
    for (std::size_t e = 0; e < count; ++e) {
      if (is_blend(e)) {
        blend_[e] = static_cast<std::uint32_t>(ramps_.size());
        ramps_.push_back(ramps_of(e));
        level_limits_.push_back({plan_[e].acceleration(), plan_[e].jerk()});
      }
    }
    for (std::size_t e = 1; e < count; ++e) {
      if (is_blend(e) && is_blend(e - 1)) {
        chains_.of[e - 1] = chains_.of[e] = 0;
        any_ = true;
      } else if (e > 1 && is_blend(e) && is_blend(e - 2) && !gains_more_alone(e - 1)) {
        chains_.of[e - 2] = chains_.of[e - 1] = chains_.of[e] = 0;
        any_ = has_lines_ = true;
      }
    }
  }

  std::vector<PlanNode> fastest() {
    Steps best{std::vector(plan_.size(), Steps::level)};
    set_limits(best);
    std::vector<PlanNode> nodes = plan_nodes(plan_, stretch_.ceiling, stretch_.held());
    if (!any_) {
      return nodes;
    }
    const double level = planned_time(nodes);
    for (const bool lines_join : {true, false}) {
      Steps steps = chains_;
      steps.lines_join = lines_join;
      std::vector<PlanNode> ramped = plan_ramps(steps);
      if (planned_time(ramped) < level) {
        best = std::move(steps);
        nodes = std::move(ramped);
        break;
      }
      if (!has_lines_) {
        break;
      }
    }
    set_limits(best);
    return nodes;
  }

 private:
  bool is_blend(std::size_t e) const { return stretch_.blend[e] != 0; }
  const BlendRamps& ramps(std::size_t e) const { return ramps_[blend_[e]]; }

  /// True if a ramp on line `e` between two blends gains more speed than one over it and half of each blend.
  bool gains_more_alone(std::size_t e) const {
    constexpr std::size_t usual = 1;  // step
    const BlendRamp& before = ramps(e - 1)[usual];
    const BlendRamp& after = ramps(e + 1)[usual];
    const MotionLimits line = plan_[e].limits();
    const double speed = std::min({before.speed, after.speed, line.speed.value});
    const double alone = reachable_speed(speed, plan_[e].length, {line.acceleration.value, line.jerk.value});
    const double length = plan_[e].length + (plan_[e - 1].length + plan_[e + 1].length) / 2;
    const double acceleration = std::min(before.acceleration.value, after.acceleration.value);
    return alone > std::sqrt(speed * speed + 2 * acceleration * length);
  }

  /// A line of a chain takes the step of the neighbour that leaves more for ramps; after the first step it
  /// may be on its own.
  std::uint8_t step_of(const Steps& steps, std::size_t e) const {
    if (is_blend(e) || steps.of[e] == Steps::level) {
      return steps.of[e];
    }
    const std::uint8_t slower = std::min(steps.of[e - 1], steps.of[e + 1]);
    return steps.lines_join || slower == 0 ? slower : Steps::separate;
  }

  void set_limits(const Steps& steps) {
    stretch_.level.clear();
    std::uint8_t before = Steps::level;
    for (std::size_t e = 0; e < plan_.size(); ++e) {
      const std::uint8_t step = step_of(steps, e);
      if (step != before && (stretch_.level.empty() || stretch_.level.back() < e)) {
        stretch_.level.push_back(static_cast<std::uint32_t>(e));
      }
      before = step;
      if (!is_blend(e)) {
        continue;
      }
      if (step == Steps::level) {
        plan_[e].set_ramps(level_limits_[blend_[e]].acceleration, level_limits_[blend_[e]].jerk);
        stretch_.hold_level(static_cast<std::uint32_t>(e));
      } else {
        plan_[e].set_ramps(ramps(e)[step].acceleration, ramps(e)[step].jerk);
      }
    }
  }

  std::vector<PlanNode> plan_ramps(Steps& steps) {
    set_limits(steps);
    std::vector<PlanNode> before;
    stop_();
    std::vector<PlanNode> nodes = plan_nodes(plan_, stretch_.ceiling, stretch_.held());
    std::vector<std::uint32_t> changed;
    for (;;) {
      changed = take_next_steps(steps, nodes, before, changed);
      if (changed.empty()) {
        return nodes;
      }
      set_limits(steps);
      before = std::move(nodes);
      stop_();
      nodes = plan_nodes_again(plan_, stretch_.ceiling, stretch_.held(), before, changed);
    }
  }

  bool ramps_over(const Steps& steps, std::size_t e) const {
    return is_blend(e) && steps.of[e] != Steps::level;
  }

  bool is_level(const PlanNode& from, const PlanNode& to) const {
    return to.junction == from.junction + 1 && stretch_.is_level(from.junction);
  }

  /// Takes the next step for every blend that `nodes` passes too fast for ramps. Returns these in order, with
  /// the neighbouring lines. Parts that are as in the plan `before` are skipped, since their blends have
  /// their steps, unless they contain one of those `changed` since.
  std::vector<std::uint32_t> take_next_steps(Steps& steps, const std::vector<PlanNode>& nodes,
                                             const std::vector<PlanNode>& before,
                                             const std::vector<std::uint32_t>& changed) const {
    std::vector<std::uint32_t> found;
    auto same = before.begin();
    auto change = changed.begin();
    for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
      const PlanNode& from = nodes[n];
      const PlanNode& to = nodes[n + 1];
      same = std::find_if(same, before.end(), [&](const PlanNode& p) { return p.junction >= from.junction; });
      change = std::find_if(change, changed.end(), [&](std::uint32_t e) { return e >= from.junction; });
      const bool is_same = before.end() - same > 1 && is_equal(same[0], from) && is_equal(same[1], to) &&
                           (change == changed.end() || *change >= to.junction);
      if (is_same || is_level(from, to)) {
        continue;
      }
      double least = std::numeric_limits<double>::infinity();
      for (std::uint32_t e = from.junction; e < to.junction; ++e) {
        if (ramps_over(steps, e)) {
          least = std::min(least, ramps(e)[steps.of[e]].speed);
        }
      }
      const SpanLimits span = span_limits(plan_, from.junction, to.junction);
      if (std::max(from.speed, to.speed) <= least * plan_slack &&
          !rises_above(least, from.speed, to.speed, span.length, span.ceiling, span.ramp())) {
        continue;
      }
      const ProfileSpeeds speeds(from.speed, to.speed, span.length, span.ceiling, span.ramp());
      double s = 0;
      for (std::uint32_t e = from.junction; e < to.junction; ++e) {
        const double begin = s;
        s += plan_[e].length;
        if (!ramps_over(steps, e)) {
          continue;
        }
        if (speeds.is_above(ramps(e)[steps.of[e]].speed * plan_slack, begin, s)) {
          ++steps.of[e];
          for (std::uint32_t beside = is_blend(e - 1) ? e : e - 1; beside <= e + (is_blend(e + 1) ? 0 : 1);
               ++beside) {
            if (found.empty() || found.back() < beside) {
              found.push_back(beside);
            }
          }
        }
      }
    }
    return found;
  }

  static bool is_equal(const PlanNode& a, const PlanNode& b) {
    return a.junction == b.junction && a.speed == b.speed;
  }

  double planned_time(const std::vector<PlanNode>& nodes) const {
    double time = 0;
    for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
      const PlanNode& from = nodes[n];
      const PlanNode& to = nodes[n + 1];
      if (is_level(from, to)) {
        time += plan_[from.junction].length / from.speed;
      } else {
        const SpanLimits span = span_limits(plan_, from.junction, to.junction);
        time += profile_time(from.speed, to.speed, span.length, span.ceiling, span.ramp());
      }
    }
    return time;
  }

  struct Ramp {
    AxisBound acceleration;
    AxisBound jerk;
  };

  Stretch& stretch_;
  std::vector<PlanElement>& plan_;
  const std::function<void()>& stop_;
  std::vector<std::uint32_t> blend_;  ///< by element: index of a blend
  std::vector<BlendRamps> ramps_;     ///< by blend
  std::vector<Ramp> level_limits_;    ///< by blend, as given in the stretch
  Steps chains_;                      ///< chains at their first step, everything else level
  bool any_ = false;
  bool has_lines_ = false;
};

}  // namespace

double blend_ramp_speed(std::size_t step, double turning, double ramping) {
  static constexpr std::array<double, std::tuple_size_v<BlendRamps>> shares{0.5, 0.75, 0.9, 1};
  constexpr double most = 0.97;  // leaves 9 % of a jerk, which is proportional to the cube of the speed
  return std::min(shares[step] * std::min(turning, ramping), most * ramping);
}

std::vector<PlanNode> plan_over_blends(Stretch& stretch, const RampsOfBlend& ramps,
                                       const std::function<void()>& stop) {
  return BlendChains(stretch, ramps, stop).fastest();
}

}  // namespace feedscope
