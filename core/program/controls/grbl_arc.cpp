#include "core/program/controls/grbl_arc.h"

#include <cmath>
#include <numbers>

namespace feedscope {
namespace {

constexpr std::uint32_t exact_every = 12;  // approximate rotations, then an exact one

/// Angle from start to end, in its direction [rad].
float angle_of(const GrblArc& arc) {
  constexpr float full_turn = 2 * std::numbers::pi_v<float>;
  constexpr float no_angle = 5e-7F;
  const float x = -arc.to_center[0];
  const float y = -arc.to_center[1];
  const float end_x = arc.end[arc.axes[0]] - (arc.start[arc.axes[0]] + arc.to_center[0]);
  const float end_y = arc.end[arc.axes[1]] - (arc.start[arc.axes[1]] + arc.to_center[1]);
  float angle = std::atan2(x * end_y - y * end_x, x * end_x + y * end_y);
  if (arc.clockwise) {
    angle -= angle >= -no_angle ? full_turn : 0;
  } else {
    angle += angle <= no_angle ? full_turn : 0;
  }
  return angle;
}

}  // namespace

GrblChords::GrblChords(const GrblArc& arc, float tolerance) : arc_(arc), place_(arc.start) {
  if (2 * arc.radius <= tolerance) {
    return;
  }
  const float angle = angle_of(arc);
  count_ = static_cast<std::uint32_t>(
      std::floor(std::fabs(0.5F * angle * arc.radius) / std::sqrt(tolerance * (2 * arc.radius - tolerance))));
  if (count_ == 0) {
    return;
  }
  const auto chords = static_cast<float>(count_);
  step_angle_ = angle / chords;
  step_along_ = (arc.end[arc.axes[2]] - arc.start[arc.axes[2]]) / chords;
  cosine_ = 2.0F - step_angle_ * step_angle_;
  sine_ = step_angle_ * 0.16666667F * (cosine_ + 4.0F);
  cosine_ *= 0.5F;
  for (std::size_t i = 0; i < 2; ++i) {
    center_[i] = arc.start[arc.axes[i]] + arc.to_center[i];
    spoke_[i] = -arc.to_center[i];
  }
}

std::array<float, 3> GrblChords::next() {
  ++done_;
  if (since_exact_ < exact_every) {
    const float turned = spoke_[0] * sine_ + spoke_[1] * cosine_;
    spoke_[0] = spoke_[0] * cosine_ - spoke_[1] * sine_;
    spoke_[1] = turned;
    ++since_exact_;
  } else {
    const float angle = static_cast<float>(done_) * step_angle_;
    const float cosine = std::cos(angle);
    const float sine = std::sin(angle);
    spoke_ = {-arc_.to_center[0] * cosine + arc_.to_center[1] * sine,
              -arc_.to_center[0] * sine - arc_.to_center[1] * cosine};
    since_exact_ = 0;
  }
  place_[arc_.axes[0]] = center_[0] + spoke_[0];
  place_[arc_.axes[1]] = center_[1] + spoke_[1];
  place_[arc_.axes[2]] += step_along_;
  return place_;
}

}  // namespace feedscope
