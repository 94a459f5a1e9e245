#include "core/models/grbl/grbl_steps.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr float segment_time = 1.0F / (100.0F * 60.0F);  // [min]
constexpr float least_steps = 1.25F;                     // of a segment
constexpr double timer_frequency = 16e6;                 // [1/s]
constexpr float timer_per_minute = 16e6F * 60.0F;
constexpr std::uint32_t longest_period = 0xffff;

}  // namespace

GrblSteps::GrblSteps(const GrblSettings& settings, GrblPlanner& planner)
    : settings_(settings), planner_(planner) {}

std::optional<float> GrblSteps::running_speed() const {
  return loaded_ ? std::optional(speed_) : std::nullopt;
}

void GrblSteps::load(GrblBlock& block) {
  if (!begun_) {
    begun_ = true;
    steps_left_ = static_cast<float>(block.step_count);
    steps_per_mm_ = steps_left_ / block.left;
    least_advance_ = block.step_count > 0 ? least_steps / steps_per_mm_ : 0;
    time_left_ = 0;
    speed_ = std::sqrt(block.entry_squared);
  }
  loaded_ = true;
  plan_profile(block);
}

void GrblSteps::plan_profile(const GrblBlock& block) {
  const float entry = block.entry_squared;
  const float exit = planner_.exit_squared();
  const float nominal = block.nominal * block.nominal;
  const float half = 0.5F / block.acceleration;
  const float length = block.left;
  exit_speed_ = std::sqrt(exit);
  phase_ = GrblPhase::accelerates;
  top_speed_ = speed_;
  accelerate_until_ = length;
  brake_after_ = length;
  const float meet = 0.5F * (length + half * (entry - exit));
  if (meet <= 0) {
    accelerate_until_ = 0;
    brake_after_ = 0;
    top_speed_ = exit_speed_;
  } else if (meet >= length) {
    phase_ = GrblPhase::brakes;
  } else {
    brake_after_ = half * (nominal - exit);
    if (brake_after_ < meet) {
      top_speed_ = block.nominal;
      if (entry == nominal) {
        phase_ = GrblPhase::cruises;
      } else {
        accelerate_until_ -= half * (nominal - entry);
      }
    } else {
      accelerate_until_ = meet;
      brake_after_ = meet;
      top_speed_ = std::sqrt(2.0F * block.acceleration * meet + exit);
    }
  }
}

/// Follows the current phase for `time` [min], or to its end; returns the time taken. `left`: of the block's
/// length [mm].
float GrblSteps::run_phase(const GrblBlock& block, float& left, float time) {
  const float before = speed_;
  const float from = left;
  const GrblPhase phase = phase_;
  switch (phase_) {
    case GrblPhase::accelerates: {
      const float change = block.acceleration * time;
      left -= time * (speed_ + 0.5F * change);
      if (left < accelerate_until_) {
        left = accelerate_until_;
        time = 2.0F * (block.left - left) / (speed_ + top_speed_);
        phase_ = left == brake_after_ ? GrblPhase::brakes : GrblPhase::cruises;
        speed_ = top_speed_;
      } else {
        speed_ += change;
      }
      break;
    }
    case GrblPhase::cruises: {
      const float ahead = left - top_speed_ * time;
      if (ahead < brake_after_) {
        time = (left - brake_after_) / top_speed_;
        left = brake_after_;
        phase_ = GrblPhase::brakes;
      } else {
        left = ahead;
      }
      break;
    }
    case GrblPhase::brakes: {
      const float change = block.acceleration * time;
      if (speed_ > change) {
        const float ahead = left - time * (speed_ - 0.5F * change);
        if (ahead > 0) {
          left = ahead;
          speed_ -= change;
          break;
        }
      }
      time = 2.0F * left / (speed_ + exit_speed_);
      left = 0;
      speed_ = exit_speed_;
      break;
    }
  }
  spans_.push_back({from, left, before, speed_, time, phase});
  return time;
}

GrblSegment GrblSteps::next() {
  GrblBlock& block = planner_.front();
  if (!loaded_) {
    load(block);
  }
  spans_.clear();
  GrblSegment segment;
  segment.block = block.id;
  float left = block.left;
  const float least_left = std::max(left - least_advance_, 0.0F);
  float most = segment_time;
  float passed = 0;
  float time = segment_time;
  do {
    passed += run_phase(block, left, time);
    if (passed < most) {
      time = most - passed;
    } else if (left > least_left) {
      most += segment_time;
      time = most - passed;
    } else {
      break;
    }
  } while (left > 0);
  segment.planned = passed;
  segment.time = settings_.step_timing && block.step_count > 0 ? timed(block, left, passed)
                                                               : 60.0 * static_cast<double>(passed);
  block.left = left;
  segment.ends_block = !(left > 0);
  if (segment.ends_block) {
    begun_ = loaded_ = false;
    planner_.pop();
  }
  return segment;
}

/// Runs whole steps at one rate, whose period is a whole number of timer counts plus one; at low rates up to
/// 8 ticks make a step.
double GrblSteps::timed(const GrblBlock&, float left, float planned) {
  const float steps_after = steps_per_mm_ * left;
  const float whole_after = std::ceil(steps_after);
  const float whole_before = std::ceil(steps_left_);
  auto ticks = static_cast<std::uint32_t>(whole_before - whole_after);
  const float time = planned + time_left_;
  const float of_step = time / (whole_before - steps_after);
  auto period = static_cast<std::uint32_t>(std::ceil(timer_per_minute * of_step));
  const int level = period < 2000 ? 0 : period < 4000 ? 1 : period < 8000 ? 2 : 3;
  period = std::min(period >> level, longest_period);
  ticks <<= level;
  steps_left_ = whole_after;
  time_left_ = (whole_after - steps_after) * of_step;
  return static_cast<double>(ticks) * (period + 1.0) / timer_frequency;
}

}  // namespace feedscope
