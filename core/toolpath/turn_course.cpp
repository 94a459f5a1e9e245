#include "core/toolpath/turn_course.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double same_direction = 1e-9;  // [rad]

/// Angle by which `a` turns about `axis` to lie in one half plane with `b`, in (-pi, pi].
double turned_about(const Vec3& axis, const Vec3& a, const Vec3& b) {
  return std::atan2(axis.dot(a.cross(b)), a.dot(b) - axis.dot(a) * axis.dot(b));
}

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
  if (across.norm() < same_direction) {  // it stays, or turns round in an unknown plane
    swing_ = 0;
    return;
  }
  quarter_ = across.normalized();
  way_ = way_on_circle();
}

TurnCourse::Way TurnCourse::way_on_circle() const {
  constexpr double same_angle = 1e-6;  // [rad]
  if (from_.size() != 2) {
    return Way::circle;
  }
  const Vec3& pole = chain_.axes()[chain_.rotary()[0]].direction;
  const Vec3 across = pole.cross(chain_.axes()[chain_.rotary()[1]].direction);
  const double first_turns = to_[0] - from_[0];
  if (with_second_at(from_[1]).dot(across) * with_second_at(to_[1]).dot(across) > 0) {
    const Vec3 end = std::cos(swing_) * start_ + std::sin(swing_) * quarter_;
    const bool comes_there = std::abs(first_turns - turn_of_first(end, to_[1])) < units::pi &&
                             std::abs(to_[1] - from_[1]) < units::pi;
    return comes_there ? Way::circle : Way::no_circle;
  }
  const bool by_second_alone =
      std::abs(start_.cross(quarter_).dot(pole)) < same_angle && std::abs(first_turns) < same_angle;
  return by_second_alone ? Way::through_pole : Way::no_circle;
}

double TurnCourse::turn_of_first(const Vec3& direction, double second) const {
  const ChainAxis& first = chain_.axes()[chain_.rotary()[0]];
  const double turned = turned_about(first.direction, start_, direction) -
                        turned_about(first.direction, with_second_at(from_[1]), with_second_at(second));
  return first.carries_part ? -turned : turned;
}

Vec3 TurnCourse::with_second_at(double angle) const {
  std::array<double, 3> angles{};
  angles[rotary_place(chain_.axes()[chain_.rotary()[1]].name)] = angle;
  return tool_direction(chain_, angles);
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
  if (way_ != Way::circle) {
    return linear(s);
  }
  const Series turned(swing_ * s / length_, swing_ / length_, 0, 0);
  const Series along = cos(turned);
  const Series across = sin(turned);
  std::array<Series, 3> direction;
  Vec3 now;
  for (int j = 0; j < 3; ++j) {
    direction[static_cast<std::size_t>(j)] = along * Series(start_[j]) + across * Series(quarter_[j]);
    now[j] = direction[static_cast<std::size_t>(j)].value();
  }
  std::optional<std::vector<Series>> angles = chain_.turning(direction, from_);
  if (!angles || angles->empty()) {
    return linear(s);
  }
  Series& first = angles->front();
  const double asked =
      from_.size() == 2 ? from_[0] + turn_of_first(now, angles->back().value()) : linear(s).front().value();
  constexpr double whole_turn = 2 * units::pi;
  first += Series(whole_turn * std::round((asked - first.value()) / whole_turn));
  return std::move(*angles);
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
  double turned = std::atan2(quarter_.dot(pole), start_.dot(pole));  // to the pole, or to the opposite one
  turned -= half_turn * std::round((turned - swing_ / 2) / half_turn);
  return std::clamp(turned / swing_, 0.0, 1.0) * length_;
}

}  // namespace feedscope
