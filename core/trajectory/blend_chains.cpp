#include "core/trajectory/blend_chains.h"

#include <algorithm>
#include <cmath>

#include "core/feed/profile_walk.h"

namespace feedscope {
namespace {

constexpr double slack = 1 + 1e-7;  // as of plan_nodes()

/// A stretch and the step of ramps that each of its elements has come to.
class BlendChains {
 public:
  BlendChains(Stretch& stretch, const RampsOfBlend& ramps_of)
      : stretch_(stretch), plan_(stretch.plan), first_step_(stretch.plan.size(), level) {
    const std::size_t count = plan_.size();
    ramps_.resize(count);
    own_.reserve(count);
    for (std::size_t e = 0; e < count; ++e) {
      own_.push_back(plan_[e].limits);
      if (is_blend(e)) {
        ramps_[e] = ramps_of(e);
      }
    }
    for (std::size_t e = 1; e < count; ++e) {
      const bool touches = is_blend(e) && is_blend(e - 1);
      const bool nearly = e > 1 && is_blend(e) && is_blend(e - 2) && !gains_more_alone(e - 1);
      if (touches || nearly) {
        any_ = true;
        std::fill(first_step_.begin() + static_cast<std::ptrdiff_t>(touches ? e - 1 : e - 2),
                  first_step_.begin() + static_cast<std::ptrdiff_t>(e + 1), 0);
      }
    }
  }

  bool any() const { return any_; }  ///< whether there is a chain

  /// All blends level.
  std::vector<PlanNode> plan_level() {
    step_.assign(plan_.size(), level);
    set_limits();
    return plan_nodes(plan_, stretch_.ceiling, stretch_.level);
  }

  std::vector<PlanNode> plan_ramps(bool lines_join) {
    step_ = first_step_;
    lines_join_ = lines_join;
    for (;;) {
      set_limits();
      std::vector<PlanNode> nodes = plan_nodes(plan_, stretch_.ceiling, stretch_.level);
      if (!take_next_steps(nodes)) {
        return nodes;
      }
    }
  }

 private:
  static constexpr std::size_t separate = std::tuple_size_v<BlendRamps> + 1;
  static constexpr std::size_t level = std::tuple_size_v<BlendRamps>;  ///< step of what is run at one speed

  bool is_blend(std::size_t e) const { return stretch_.blend[e] != 0; }

  /// Whether a ramp on line `e` between two blends gains more speed than one over it and half of each blend.
  bool gains_more_alone(std::size_t e) const {
    constexpr std::size_t usual = 1;  // step
    const BlendRamp& before = ramps_[e - 1][usual];
    const BlendRamp& after = ramps_[e + 1][usual];
    const double speed = std::min({before.speed, after.speed, own_[e].speed.value});
    const double alone =
        reachable_speed(speed, plan_[e].length, {own_[e].acceleration.value, own_[e].jerk.value});
    const double length = plan_[e].length + (plan_[e - 1].length + plan_[e + 1].length) / 2;
    const double acceleration = std::min(before.acceleration.value, after.acceleration.value);
    return alone > std::sqrt(speed * speed + 2 * acceleration * length);
  }

  /// A line of a chain goes with the neighbour that leaves more for ramps, or by itself behind the first
  /// step.
  std::size_t step_of(std::size_t e) const {
    if (is_blend(e) || step_[e] == level) {
      return step_[e];
    }
    const std::size_t slower = std::min(step_[e - 1], step_[e + 1]);
    return lines_join_ || slower == 0 ? slower : separate;
  }

  void set_limits() {
    stretch_.level.clear();
    std::size_t before = level;
    for (std::size_t e = 0; e < plan_.size(); ++e) {
      MotionLimits& limits = plan_[e].limits;
      limits = own_[e];
      const std::size_t step = step_of(e);
      if (step != before && (stretch_.level.empty() || stretch_.level.back() < e)) {
        stretch_.level.push_back(static_cast<std::uint32_t>(e));
      }
      before = step;
      if (is_blend(e) && step == level) {
        stretch_.hold_level(static_cast<std::uint32_t>(e));
      } else if (is_blend(e)) {
        limits.acceleration = ramps_[e][step].acceleration;
        limits.jerk = ramps_[e][step].jerk;
      }
    }
  }

  /// The next step for every blend that `nodes` passes too fast for ramps; whether there is one.
  bool take_next_steps(const std::vector<PlanNode>& nodes) {
    bool found = false;
    for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
      const std::size_t first = nodes[n].junction;
      const std::size_t last = nodes[n + 1].junction;
      if (std::all_of(step_.begin() + static_cast<std::ptrdiff_t>(first),
                      step_.begin() + static_cast<std::ptrdiff_t>(last),
                      [](std::size_t step) { return step == level; })) {
        continue;
      }
      const SpanLimits span = span_limits(plan_, first, last);
      const SpeedProfile profile =
          plan_profile(nodes[n].speed, 0, nodes[n + 1].speed, span.length, span.ceiling, span.ramp());
      ProfileWalk walk(profile);
      double s = 0;
      for (std::size_t e = first; e < last; ++e) {
        s += plan_[e].length;
        walk.move_to(s);
        if (is_blend(e) && step_[e] != level && walk.largest_speed() > ramps_[e][step_[e]].speed * slack) {
          ++step_[e];
          found = true;
        }
      }
    }
    return found;
  }

  Stretch& stretch_;
  std::vector<PlanElement>& plan_;
  std::vector<MotionLimits> own_;        ///< of every element at one speed
  std::vector<BlendRamps> ramps_;        ///< an element; of blends only
  std::vector<std::size_t> first_step_;  ///< an element
  std::vector<std::size_t> step_;        ///< an element
  bool any_ = false;
  bool lines_join_ = true;
};

double planned_time(const Stretch& stretch, const std::vector<PlanNode>& nodes) {
  double time = 0;
  for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
    const std::size_t first = nodes[n].junction;
    const std::size_t last = nodes[n + 1].junction;
    if (last == first + 1 && stretch.is_level(first)) {
      time += stretch.plan[first].length / nodes[n].speed;
      continue;
    }
    const SpanLimits span = span_limits(stretch.plan, first, last);
    time += plan_profile(nodes[n].speed, 0, nodes[n + 1].speed, span.length, span.ceiling, span.ramp())
                .duration();
  }
  return time;
}

}  // namespace

double blend_ramp_speed(std::size_t step, double turning, double ramping) {
  static constexpr std::array<double, std::tuple_size_v<BlendRamps>> shares{0.5, 0.75, 0.9, 1};
  constexpr double most = 0.97;  // leaves 9 % of a jerk, which grows with the cube of the speed
  return std::min(shares[step] * std::min(turning, ramping), most * ramping);
}

std::vector<PlanNode> plan_over_blends(Stretch& stretch, const RampsOfBlend& ramps) {
  BlendChains chains(stretch, ramps);
  std::vector<PlanNode> best = chains.plan_level();
  if (!chains.any()) {
    return best;
  }
  double least = planned_time(stretch, best);
  for (const bool lines_join : {true, false}) {
    const std::vector<PlanElement> plan = stretch.plan;
    const std::vector<std::uint32_t> level = stretch.level;
    std::vector<PlanNode> nodes = chains.plan_ramps(lines_join);
    const double time = planned_time(stretch, nodes);
    if (time < least) {
      least = time;
      best = std::move(nodes);
    } else {
      stretch.plan = plan;
      stretch.level = level;
    }
  }
  return best;
}

}  // namespace feedscope
