#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/rotary/rotary_course.h"
#include "core/analysis/rotary/rotary_figures.h"
#include "core/toolpath/joint_shape.h"
#include "tests/contract/checks.h"

namespace feedscope::contract {
namespace {

constexpr std::size_t axes = rotary_names.size();

/// What the largest turn within a program is, by which its angles are rounded [rad].
double size_of(const Toolpath& path) {
  double largest = 1;
  for (const SegmentTurn& turn : path.segment_turns) {
    for (std::size_t i = 0; i < axes; ++i) {
      largest = std::max({largest, std::abs(turn.from[i]), std::abs(turn.to[i])});
    }
  }
  return largest;
}

/// Whether joints shape the whole segment or none reaches into it: beside a joint that reaches into a longer
/// one, its jerk and that of a ramp add up.
bool is_held(const Toolpath& path, const RotaryCourse& course, std::uint32_t segment) {
  const double length = path.segments[segment].length;
  const TurnJoint* before = segment > 0 ? course.joint_behind(segment - std::size_t{1}) : nullptr;
  const TurnJoint* behind = course.joint_behind(segment);
  const auto holds = [&](double reach) { return reach == 0 || shapes_segment(reach, length); };
  return (before == nullptr || holds(before->behind)) && (behind == nullptr || holds(behind->before));
}

/// The velocity in the middle of a part against the difference of the angles beside it.
Result check_slope(const Motion& motion, const RotaryCourse& course, const Part& part,
                   const Machine& machine) {
  constexpr double away = 1e-3;  // of its duration
  const RotarySample before = course.at(motion.at(part, 0.5 - away));
  const RotarySample middle = course.at(motion.at(part, 0.5));
  const RotarySample behind = course.at(motion.at(part, 0.5 + away));
  const double time = 2 * away * part.duration;
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    const std::size_t i = rotary_names.find(axis.name);
    const double way = behind.rotary[i].position - before.rotary[i].position;
    const double larger = std::max(std::abs(before.rotary[i].velocity), std::abs(behind.rotary[i].velocity));
    const double change = std::abs(behind.rotary[i].velocity - before.rotary[i].velocity);
    const double rounding = 1e-8 * (1 + std::abs(middle.rotary[i].position));
    if (std::abs(way - middle.rotary[i].velocity * time) > (0.05 * larger + change) * time + rounding) {
      return Finding{
          "rotary-derivative",
          fmt::format("axis {} turns by {} rad in {} s at {} rad/s in line {}", axis.name, way, time,
                      middle.rotary[i].velocity, motion.toolpath().segments[part.segment].line)};
    }
  }
  return {};
}

/// Which axis is above its velocity at an instant, and by what factor.
Result check_turning_velocity(const RotarySample& sample, double most, const Machine& machine,
                              std::uint32_t line, double time) {
  const auto check = [&](char name, double velocity, double limit) -> Result {
    if (std::abs(velocity) <= most * limit) {  // not a number: the axis does not hold the tip
      return {};
    }
    return std::isnan(velocity) ? Result()
                                : Finding{"turning-velocity",
                                          fmt::format("axis {} at {} times its velocity in line {} at {} s",
                                                      name, std::abs(velocity) / limit, line, time)};
  };
  for (std::size_t i = 0; i < axes; ++i) {
    const AxisLimits* linear = machine.axes.find(coordinate_names[i]);
    const RotaryAxis* rotary = machine.kinematics.find(rotary_names[i]);
    Result wrong = linear != nullptr ? check(coordinate_names[i], sample.linear[i].velocity, linear->velocity)
                                     : Result();
    if (!wrong && rotary != nullptr) {
      wrong = check(rotary->name, sample.rotary[i].velocity, rotary->velocity);
    }
    if (wrong) {
      return wrong;
    }
  }
  return {};
}

/// The largest velocities at the instants looked at, which the figures of the run are not below.
class Seen {
 public:
  void add(const RotarySample& sample) {
    for (std::size_t i = 0; i < axes; ++i) {
      for (const auto& [state, largest] :
           {std::pair(&sample.linear[i], &linear_[i]), std::pair(&sample.rotary[i], &rotary_[i])}) {
        *largest = std::isnan(state->velocity) ? *largest : std::max(*largest, std::abs(state->velocity));
      }
    }
  }

  Result check(const RotaryFigures& figures) const {
    constexpr double rounding = 1e-6;
    for (std::size_t i = 0; i < axes; ++i) {
      const double linear = figures.linear ? (*figures.linear)[i].velocity : 0;
      const double rotary = figures.rotary[i].velocity;
      if (linear < linear_[i] * (1 - rounding) - rounding ||
          rotary < rotary_[i] * (1 - rounding) - rounding) {
        return Finding{"rotary-peak",
                       fmt::format("largest velocities {} of {} and {} of {}, seen {} and {}", linear,
                                   coordinate_names[i], rotary, rotary_names[i], linear_[i], rotary_[i])};
      }
    }
    return {};
  }

 private:
  std::array<double, axes> linear_{};
  std::array<double, axes> rotary_{};
};

/// How many even instants of a part show the axes go up and down with the angles.
int samples_of(const Motion& motion, const RotaryCourse& course, const Part& part) {
  constexpr double least = 12;
  constexpr double step = 0.05;  // [rad]
  const auto from = course.at(motion.at(part, 0)).angles();
  const auto to = course.at(motion.at(part, 1)).angles();
  double turned = 0;
  for (std::size_t i = 0; i < axes; ++i) {
    turned += std::isnan(to[i]) ? 0 : std::abs(to[i] - from[i]);
  }
  return static_cast<int>(std::max(least, turned / step));
}

}  // namespace

Result check_rotary(const Motion& motion, const Guarantees& promised, const Machine& machine) {
  const auto run = std::make_shared<const Trajectory>(motion.run());
  const std::shared_ptr<const RotaryCourse> course = rotary_course_of(run, machine);
  if (!course || run->path().is_executed()) {
    return {};
  }
  const Toolpath& path = *run->path().programmed();
  const double rounding = 1e-7 * size_of(path);
  Seen seen;
  RotarySample last;
  bool was_curve = false;
  for (const Part& part : motion.parts()) {
    const int samples = samples_of(motion, *course, part);
    for (int k = 0; k <= samples; ++k) {
      const State state = motion.at(part, static_cast<double>(k) / samples);
      const RotarySample sample = course->at(state);
      const Segment& block = path.segments[part.segment];
      if (block.rapid || !promised.turning_rapids_only) {
        if (Result wrong =
                check_turning_velocity(sample, promised.turning_velocity, machine, block.line, state.time)) {
          return wrong;
        }
      }
      seen.add(sample);
      if (motion.lags()) {
        continue;
      }
      for (const RotaryAxis& axis : machine.kinematics.rotary) {
        const std::size_t i = rotary_names.find(axis.name);
        const bool turns = path.segment_turn(part.segment) != nullptr;
        const bool of_block = part.place == Place::line || part.place == Place::arc;
        const bool kept = promised.lines.acceleration.of != KeptLimit::Of::nothing &&
                          promised.continuity != Continuity::position;
        if (kept && turns && of_block &&
            std::abs(sample.rotary[i].velocity) > 1.01 * promised.feed * axis.velocity + rounding) {
          return Finding{"rotary-velocity", fmt::format("axis {} at {} rad/s of {} in line {} at {} s",
                                                        axis.name, sample.rotary[i].velocity, axis.velocity,
                                                        path.segments[part.segment].line, state.time)};
        }
        // Shares of several joints, corners and ramps add up a little, beside a joint in a longer block much.
        constexpr double most_held = 1.3;
        constexpr double most_beside = 1.8;
        const bool held = is_held(path, *course, part.segment);
        const double most = held ? most_held : most_beside;
        if (promised.holds_rotary_ramps && turns && (of_block || part.place == Place::blend) &&
            !promised.follows_compaction &&
            std::abs(sample.rotary[i].acceleration) > most * axis.acceleration + rounding) {
          return Finding{"rotary-acceleration",
                         fmt::format("axis {} at {} rad/s2 of {} in line {} at {} s", axis.name,
                                     sample.rotary[i].acceleration, axis.acceleration,
                                     path.segments[part.segment].line, state.time)};
        }
        if (promised.holds_rotary_ramps && turns && of_block && !promised.follows_compaction && held &&
            std::abs(sample.rotary[i].jerk) > most * axis.jerk + rounding) {
          return Finding{"rotary-jerk", fmt::format("axis {} at {} rad/s3 of {} in line {} at {} s",
                                                    axis.name, sample.rotary[i].jerk, axis.jerk,
                                                    path.segments[part.segment].line, state.time)};
        }
        // Joined blocks leave the programmed ones, as curves do.
        const bool curves = part.place == Place::curve || was_curve || promised.follows_compaction;
        if (&part != &motion.parts().front() && k == 0 && !curves &&
            std::abs(sample.rotary[i].position - last.rotary[i].position) > rounding) {
          return Finding{"rotary-jump", fmt::format("axis {} jumps by {} rad in line {} at {} s", axis.name,
                                                    sample.rotary[i].position - last.rotary[i].position,
                                                    path.segments[part.segment].line, state.time)};
        }
      }
      last = sample;
    }
    was_curve = part.place == Place::curve;
    if (was_curve || motion.lags()) {
      continue;  // its places on the programmed lines are the nearest ones
    }
    if (Result wrong = check_slope(motion, *course, part, machine)) {
      return wrong;
    }
  }
  return seen.check(rotary_figures(course, promised.limits_jerk));
}

}  // namespace feedscope::contract
