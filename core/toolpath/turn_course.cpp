#include "core/toolpath/turn_course.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr double same_direction = 1e-9;  // [rad]

}  // namespace

Vec3 tool_direction(const KinematicChain& chain, const std::array<double, 3>& angles) {
  std::vector<double> places(chain.size(), 0);
  for (const std::size_t k : chain.rotary()) {
    places[k] = angles[rotary_place(chain.axes()[k].name)];
  }
  return chain.pose(places, 0).direction;
}

std::array<Series, 3> tip_on_machine(const PartOnMachine& part, const CurvePoint& at) {
  const Vec3 position = part.turn * at.position + part.zero;
  const Vec3 d1 = part.turn * at.d1;
  const Vec3 d2 = part.turn * at.d2;
  const Vec3 d3 = part.turn * at.d3;
  std::array<Series, 3> tip;
  for (int j = 0; j < 3; ++j) {
    tip[static_cast<std::size_t>(j)] = {position[j], d1[j], d2[j], d3[j]};
  }
  return tip;
}

TurnCourse::TurnCourse(const KinematicChain& chain, const SegmentTurn& turn, double length)
    : chain_(chain), length_(length) {
  for (const std::size_t k : chain.rotary()) {
    from_.push_back(turn.from[rotary_place(chain.axes()[k].name)]);
    to_.push_back(turn.to[rotary_place(chain.axes()[k].name)]);
  }
  if (!turn.great_circle) {
    return;
  }
  start_ = tool_direction(chain, turn.from);
  const Vec3 end = tool_direction(chain, turn.to);
  const Vec3 across = end - start_.dot(end) * start_;
  swing_ = std::atan2(across.norm(), start_.dot(end));
  if (across.norm() < same_direction) {  // it stays, or goes round by an unknown way
    swing_ = 0;
    return;
  }
  quarter_ = across.normalized();
}

std::vector<Series> TurnCourse::linear(double s) const {
  std::vector<Series> angles;
  for (std::size_t k = 0; k < from_.size(); ++k) {
    const double way = to_[k] - from_[k];
    angles.emplace_back(from_[k] + s / length_ * way, way / length_, 0, 0);
  }
  return angles;
}

std::vector<Series> TurnCourse::at(double s) const {
  std::vector<Series> even = linear(s);
  if (swing_ == 0) {
    return even;
  }
  const Series turned(swing_ * s / length_, swing_ / length_, 0, 0);
  const Series along = cos(turned);
  const Series across = sin(turned);
  std::array<Series, 3> direction;
  for (int j = 0; j < 3; ++j) {
    direction[static_cast<std::size_t>(j)] = along * Series(start_[j]) + across * Series(quarter_[j]);
  }
  std::vector<double> near;
  for (const Series& angle : even) {
    near.push_back(angle.value());
  }
  std::optional<std::vector<Series>> angles = chain_.turning(direction, near);
  return angles && !angles->empty() ? std::move(*angles) : std::move(even);
}

std::array<double, 3> TurnCourse::angles(double s) const {
  std::array<double, 3> angles{};
  const std::vector<Series> all = at(s);
  for (std::size_t k = 0; k < all.size(); ++k) {
    angles[rotary_place(chain_.axes()[chain_.rotary()[k]].name)] = all[k].value();
  }
  return angles;
}

std::optional<double> TurnCourse::nearest_to_pole() const {
  if (swing_ == 0 || from_.size() != 2) {
    return std::nullopt;
  }
  const Vec3& pole = chain_.axes()[chain_.rotary()[0]].direction;
  const double half_turn = std::acos(-1.0);
  double turned = std::atan2(quarter_.dot(pole), start_.dot(pole));  // to the pole, or to the one opposite
  turned -= half_turn * std::round((turned - swing_ / 2) / half_turn);
  return std::clamp(turned / swing_, 0.0, 1.0) * length_;
}

}  // namespace feedscope
