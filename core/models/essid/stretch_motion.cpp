#include <algorithm>
#include <cmath>

#include "core/feed/profile_walk.h"
#include "core/models/essid/stretch.h"

namespace feedscope {

void StretchRunner::move(const std::vector<PlanNode>& nodes, std::size_t count, std::size_t first_segment,
                         Progress* progress) {
  constexpr std::size_t report_every = 4096;
  speed_ = 0;
  std::size_t reported = 0;
  for (std::size_t n = 0; n + 1 < nodes.size();) {
    const std::int32_t blend = elements_[nodes[n].junction].blend;
    if (blend >= 0) {
      if (const auto reached = move_over_blend(nodes, n)) {
        n = *reached;
        continue;
      }
      if (is_level(blends_[static_cast<std::size_t>(blend)])) {
        pass_level(nodes[n].junction);
        ++n;
        continue;
      }
    }
    const SpanLimits span = span_limits(plan_, nodes[n].junction, nodes[n + 1].junction);
    add_profile(profile_to(nodes[n + 1].speed, span, speed_, 0), span, nodes[n].junction,
                nodes[n + 1].junction);
    ++n;
    if (progress != nullptr && nodes[n].junction >= reported + report_every) {
      reported = nodes[n].junction;
      const double done = static_cast<double>(first_segment) + static_cast<double>(count) *
                                                                   static_cast<double>(reported) /
                                                                   static_cast<double>(plan_.size());
      progress->report(done / static_cast<double>(toolpath_.segments.size()));
    }
  }
}

std::optional<std::size_t> StretchRunner::move_over_blend(const std::vector<PlanNode>& nodes, std::size_t n) {
  const std::size_t e = nodes[n].junction;
  const Blend& blend = blends_[static_cast<std::size_t>(elements_[e].blend)];
  if (settings_.reading == EssidReading::strict || blend.turn > sharp_turn) {
    return std::nullopt;
  }
  std::size_t target = n + 1;
  // The node at the blend's end only repeats its entry speed: look further, unless another blend starts
  // there.
  if (nodes[target].junction == e + 1 && elements_[e + 1].blend < 0) {
    ++target;
  }
  const std::size_t last = nodes[target].junction;
  const double end_speed = nodes[target].speed;
  const SpanLimits span = span_limits(plan_, e + 1, last);

  SpeedBound ceiling = blend.feed;
  ceiling.lower(last == e + 1 ? end_speed : reachable_speed(end_speed, span.length, span.ramp()),
                {CauseKind::ramp_down});
  if (ceiling.value < speed_) {
    return std::nullopt;
  }
  if (ceiling.value <= speed_ * (1 + 1e-9) && keeps_rows_at(blend.shape, speed_, blend_limits_)) {
    return std::nullopt;  // nothing to gain
  }
  // The law is worth its samples where the second half of the blend, used to accelerate, gains some speed,
  // and it means something where what constant speed alone asks of the parametric jerk hardly changes in a
  // sample.
  constexpr double least_gain = 0.05;
  constexpr double least_samples = 40;
  const double time = plan_[e].length / speed_;
  const double samples = std::max(time / settings_.period, least_samples);
  const BlendShape::Point entry = blend.shape.at(0);
  const double steady_jerk = std::abs(entry.ddsigma) * std::pow(speed_ / entry.sigma, 3);
  if (blend.jerk * time * time / 8 < least_gain * speed_ || 16 * steady_jerk > samples * blend.jerk) {
    return std::nullopt;
  }
  const double period = time / samples;
  constexpr double sampled_slack = 1.005;  // what the rows of eq 24 may push the speed above its ceiling
  const double fastest = ceiling.value;
  for (const double share : {1.0, 0.5, 0.0}) {
    ceiling.value = speed_ + share * (fastest - speed_);
    const BlendMotion motion = run_blend(blend.shape, speed_, ceiling, blend_limits_, period);
    if (!motion.complete || motion.peak_speed > fastest * sampled_slack) {
      continue;
    }
    const double carried = settings_.reading == EssidReading::published ? 0 : motion.exit_acceleration;
    if (last == e + 1) {  // the next blend begins without acceleration, eq 25
      if (motion.exit_speed > end_speed * (1 + 1e-9)) {
        continue;
      }
      add_blend_steps(motion, e);
      speed_ = motion.exit_speed;
      return target;
    }
    const SpeedProfile profile = profile_to(end_speed, span, motion.exit_speed, carried);
    if (profile.feasible && first_too_fast(plan_, ceiling_, e + 1, last, profile) == last) {
      add_blend_steps(motion, e);
      add_profile(profile, span, e + 1, last);
      return target;
    }
  }
  return std::nullopt;
}

void StretchRunner::pass_level(std::size_t element) {
  const Blend& blend = blends_[static_cast<std::size_t>(elements_[element].blend)];
  const Cause cause = plan_[element].limits.speed.cause;
  BlendMotion motion;
  motion.exit_speed = speed_;
  if (settings_.reading != EssidReading::strict && keeps_rows_at(blend.shape, speed_, blend_limits_)) {
    builder_.add_piece({0, 0, speed_, 0, 0, elements_[element].index, cause}, plan_[element].length / speed_);
  } else {
    const double du = speed_ / blend.shape.at(0).sigma;
    motion.steps = {{1 / du, 0, du, 0, 0, cause}};
  }
  add_blend_steps(motion, element);
}

SpeedProfile StretchRunner::profile_to(double target, const SpanLimits& span, double speed,
                                       double acceleration) const {
  const auto plan = [&](double end) {
    return plan_profile(speed, acceleration, end, span.length, span.ceiling, span.ramp());
  };
  SpeedProfile profile = plan(target);
  const double settled = speed + acceleration * std::abs(acceleration) / (2 * span.jerk.value);
  if (profile.feasible || target <= settled) {
    return profile;
  }
  // Too short to reach `target`: as fast as it gets.
  double low = std::max(settled, 0.0);
  double high = target;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (plan(middle).feasible ? low : high) = middle;
  }
  return plan(low);
}

void StretchRunner::add_profile(const SpeedProfile& profile, const SpanLimits& span, std::size_t first,
                                std::size_t last) {
  const bool slows_first = profile.peak < profile.v0;
  ProfileWalk walk(profile);
  double start = 0;
  for (std::size_t e = first; e < last; ++e) {
    const double end = start + plan_[e].length;
    const auto note_speed = [&](double BlendRecord::*field) {
      if (elements_[e].blend >= 0) {
        builder_.blend_record(blends_[static_cast<std::size_t>(elements_[e].blend)].record).*field =
            walk.at().v;
      }
    };
    note_speed(&BlendRecord::entry_speed);
    while (walk.phase() < 7) {
      const double left = walk.phase_left();
      const double time = e + 1 == last ? left : walk.time_to(end);
      const std::size_t phase = walk.phase();
      Cause cause;
      if (phase == 3) {
        cause = plan_[e].limits.speed.cause;
      } else if (phase > 3 || slows_first) {
        cause = {CauseKind::ramp_down};
      } else if (phase == 1) {
        cause = {CauseKind::axis_acceleration, span.acceleration.axis};
      } else {
        cause = {CauseKind::axis_jerk, span.jerk.axis};
      }
      const Motion1d& at = walk.at();
      builder_.add_piece({0, at.s - start, at.v, at.a, walk.jerk(), elements_[e].index, cause}, time);
      walk.move_by(time);
      if (time < left) {
        break;
      }
    }
    note_speed(&BlendRecord::exit_speed);
    start = end;
  }
  speed_ = walk.at().v;
}

void StretchRunner::add_blend_steps(const BlendMotion& motion, std::size_t element) {
  const Blend& blend = blends_[static_cast<std::size_t>(elements_[element].blend)];
  for (const BlendStep& step : motion.steps) {
    builder_.add_piece(
        {0, step.u, step.du, step.ddu, step.dddu, elements_[element].index, step.cause, Law::parameter},
        step.duration);
  }
  BlendRecord& record = builder_.blend_record(blend.record);
  record.entry_speed = speed_;
  record.exit_speed = motion.exit_speed;
}

}  // namespace feedscope
