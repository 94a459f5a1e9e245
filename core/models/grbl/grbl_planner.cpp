#include "core/models/grbl/grbl_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope {
namespace {

using FloatAxes = GrblSettings::Axes;

struct LeastLimit {
  float value;
  std::int8_t axis;
};

/// min_i limit_i / |u_i| over the axes that move.
LeastLimit least_along(const FloatAxes& limit, const FloatAxes& u) {
  LeastLimit least{std::numeric_limits<float>::max(), -1};
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (u[i] != 0) {
      const float along = std::fabs(limit[i] / u[i]);
      if (along < least.value) {
        least = {along, static_cast<std::int8_t>(i)};
      }
    }
  }
  return least;
}

float square(float x) {
  return x * x;
}

/// Makes `v` a unit vector; returns its previous length.
float make_unit(FloatAxes& v) {
  float sum = 0;
  for (const float x : v) {
    sum += x * x;
  }
  const float length = std::sqrt(sum);
  const float inverse = 1.0F / length;
  for (float& x : v) {
    x *= inverse;
  }
  return length;
}

/// Largest speed squared from direction `before` to `u`.
float junction_squared(const FloatAxes& before, const FloatAxes& u, const GrblSettings& settings) {
  constexpr float straight = 0.999999F;
  constexpr float unlimited = 1e38F;
  float cosine = 0;
  FloatAxes across{};
  for (std::size_t i = 0; i < u.size(); ++i) {
    cosine -= before[i] * u[i];
    across[i] = u[i] - before[i];
  }
  if (cosine > straight) {
    return 0;
  }
  if (cosine < -straight) {
    return unlimited;
  }
  make_unit(across);
  const float acceleration = least_along(settings.acceleration, across).value;
  const float sine = std::sqrt(0.5F * (1.0F - cosine));
  return std::max(0.0F, (acceleration * settings.junction_deviation * sine) / (1.0F - sine));
}

}  // namespace

GrblPlanner::GrblPlanner(const GrblSettings& settings) : settings_(settings) {}

void GrblPlanner::set_place(const std::array<float, 3>& mm) {
  place_.mm = mm;
  for (std::size_t i = 0; i < mm.size(); ++i) {
    place_.steps[i] = static_cast<std::int32_t>(std::lround(mm[i] * settings_.steps[i]));
  }
}

bool GrblPlanner::add(const Line& line, std::optional<float> running_speed) {
  constexpr float least_speed = 1;  // [mm/min]
  reached_front_ = false;
  GrblBlock block;
  block.id = line.id;
  FloatAxes u{};
  GrblPlace target = place_;
  target.mm = line.target;
  const bool has_steps = settings_.has_steps();
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (has_steps) {
      target.steps[i] = static_cast<std::int32_t>(std::lround(line.target[i] * settings_.steps[i]));
      const std::int32_t delta = target.steps[i] - place_.steps[i];
      block.steps[i] = static_cast<std::uint32_t>(std::abs(delta));
      block.step_count = std::max(block.step_count, block.steps[i]);
      u[i] = static_cast<float>(delta) / settings_.steps[i];
    } else {
      u[i] = line.target[i] - place_.mm[i];
    }
  }
  const bool moves = has_steps ? block.step_count > 0 : u != FloatAxes{};
  if (!moves) {
    return false;
  }
  block.left = make_unit(u);
  const LeastLimit acceleration = least_along(settings_.acceleration, u);
  const LeastLimit rate = least_along(settings_.rate, u);
  block.acceleration = acceleration.value;
  block.acceleration_axis = acceleration.axis;
  const bool of_axis = line.rapid || line.feed > rate.value;
  block.nominal = std::max(of_axis ? rate.value : line.feed, least_speed);
  block.speed_axis = of_axis ? rate.axis : std::int8_t(-1);

  if (!blocks_.empty()) {
    const float most = square(std::min(block.nominal, nominal_before_));
    const float junction = junction_squared(direction_before_, u, settings_);
    block.max_entry_squared = std::min(most, junction);
    block.entry = junction < most                    ? GrblEntry::junction
                  : block.nominal <= nominal_before_ ? GrblEntry::own_speed
                                                     : GrblEntry::speed_before;
  }
  nominal_before_ = block.nominal;
  direction_before_ = u;
  place_ = target;
  blocks_.push_back(block);
  replan(running_speed);
  return true;
}

void GrblPlanner::replan(std::optional<float> running_speed) {
  std::size_t i = blocks_.size() - 1;
  if (i == planned_) {
    return;
  }
  GrblBlock& newest = blocks_[i];
  newest.entry_squared = std::min(newest.max_entry_squared, 2.0F * newest.acceleration * newest.left);
  for (--i;; --i) {
    if (i == 0) {
      reached_front_ = true;
      if (running_speed) {
        blocks_[0].entry_squared = square(*running_speed);
      }
    }
    if (i == planned_) {
      break;
    }
    GrblBlock& block = blocks_[i];
    if (block.entry_squared != block.max_entry_squared) {
      block.entry_squared = std::min(block.max_entry_squared,
                                     blocks_[i + 1].entry_squared + 2.0F * block.acceleration * block.left);
    }
  }
  for (std::size_t next = planned_ + 1; next < blocks_.size(); ++next) {
    const GrblBlock& before = blocks_[next - 1];
    GrblBlock& after = blocks_[next];
    if (before.entry_squared < after.entry_squared) {
      const float reached = before.entry_squared + 2.0F * before.acceleration * before.left;
      if (reached < after.entry_squared) {
        after.entry_squared = reached;
        planned_ = next;
      }
    }
    if (after.entry_squared == after.max_entry_squared) {
      planned_ = next;
    }
  }
}

void GrblPlanner::pop() {
  blocks_.pop_front();
  planned_ = planned_ > 0 ? planned_ - 1 : 0;
}

}  // namespace feedscope
