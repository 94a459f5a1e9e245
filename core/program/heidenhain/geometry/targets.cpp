#include "core/program/heidenhain/geometry/targets.h"

#include <cmath>

#include "core/program/path/plane_points.h"

namespace feedscope::heidenhain {

std::uint8_t bits_of(Plane plane) {
  return static_cast<std::uint8_t>(1 << first_axis(plane) | 1 << second_axis(plane));
}

Vec3 Targets::of(const MotionWords& words) const {
  Vec3 target = contour_.position();
  for (int axis = 0; axis < 3; ++axis) {
    target[axis] = words.axes[static_cast<std::size_t>(axis)].from(target[axis]);
  }
  return target;
}

Vec3 Targets::polar(const MotionWords& words) {
  const Vec2 from_pole = in_plane(contour_.position() - *modal_.pole, modal_.pole_plane);
  // On the pole itself the last angle applies.
  const double angle_before =
      from_pole.norm() > same_point ? std::atan2(from_pole.y(), from_pole.x()) : last_polar_angle_;
  const double radius = words.polar_radius.from(from_pole.norm());
  const double angle = words.polar_angle.from(angle_before);
  last_polar_angle_ = angle;
  const Vec2 end =
      in_plane(*modal_.pole, modal_.pole_plane) + radius * Vec2(std::cos(angle), std::sin(angle));
  const int normal = normal_axis(modal_.pole_plane);
  Vec3 target = contour_.position();
  target[normal] = words.axes[static_cast<std::size_t>(normal)].from(target[normal]);
  return from_plane(end, modal_.pole_plane, target);
}

bool Targets::has_pole(std::uint32_t column) const {
  if (!modal_.pole) {
    report(Severity::error, "pole", 0, column, [] {
      return Text{NC_("core", "polar coordinates without a pole"),
                  NC_("core", "a line to the known end is used; write the pole (CC, or I and J) before it")};
    });
  }
  return modal_.pole.has_value();
}

void Targets::set_pole(const MotionWords& words) {
  const Vec3 base = contour_.position();
  Vec3 pole = modal_.pole.value_or(base);
  if (!words.has_axes()) {
    pole = base;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const OptionalWord& word = words.axes[static_cast<std::size_t>(axis)];
    if (word.given) {
      pole[axis] = word.incremental ? base[axis] + word.value : word.value;
    }
  }
  modal_.pole = pole;
  if (!words.has_axes()) {
    modal_.pole_plane = plane();
  }
  for (const Plane plane : {Plane::xy, Plane::zx, Plane::yz}) {
    const auto given = [&](int axis) { return words.axes[static_cast<std::size_t>(axis)].given; };
    if (given(first_axis(plane)) && given(second_axis(plane))) {
      modal_.pole_plane = plane;
    }
  }
}

ContourElement Targets::element(const MotionWords& words, const Vec3& target) const {
  ContourElement element;
  element.target = target;
  element.plane = plane();
  element.feed = feeds_.of(words);
  element.side = modal_.side;
  element.tool_radius = modal_.tool_radius;
  element.place = contour_place(words.first_column, words.axis_bits());
  element.place.incremental = words.incremental_bits();
  return element;
}

void Targets::note_programmed_axes(const MotionWords& words) {
  programmed_axes_ |= words.absolute_bits();
  programmed_axes_ |= words.has_polar() ? bits_of(modal_.pole_plane) : std::uint8_t{0};
}

}  // namespace feedscope::heidenhain
