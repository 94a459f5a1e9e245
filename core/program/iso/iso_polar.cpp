// The part of IsoReader that reads radius and angle instead of two coordinates: G16, and "@" and "^" of
// LinuxCNC.
#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/program/iso/iso_reader.h"

namespace feedscope {

Vec3 IsoReader::polar_target(Vec3 target) {
  constexpr std::string_view axis_letters = "XYZ";
  const int first = first_axis(state_.plane);
  const int second = second_axis(state_.plane);
  const char radius = axis_letters[static_cast<std::size_t>(first)];
  const char angle = axis_letters[static_cast<std::size_t>(second)];
  PolarState& polar = state_.polar;
  if (!words_.has(radius) && !words_.has(angle)) {
    return target;
  }
  if (words_.has(radius)) {
    polar.radius = state_.to_mm(words_[radius].value);
    polar.center = state_.incremental ? path().position() : Vec3(Vec3::Zero());
  }
  if (words_.has(angle)) {
    const double turn = units::from_deg(words_[angle].value);
    polar.angle = state_.incremental ? polar.angle + turn : turn;
  }
  target[first] = polar.center[first] + polar.radius * std::cos(polar.angle);
  target[second] = polar.center[second] + polar.radius * std::sin(polar.angle);
  return target;
}

Vec3 IsoReader::distance_and_angle_target(Vec3 target) {
  const Word& first = words_.distance != nullptr ? *words_.distance : *words_.angle;
  if (words_.has_any("XY")) {
    report(Severity::error, "polar-words", 0, first.column, [&] {
      return Text{fmt::format("{} stands in a block with X or Y", first.letter),
                  "X and Y are left out; write either of them"};
    });
  }
  const Vec3 position = path().position();
  double distance = std::hypot(position.x(), position.y());
  double angle = std::atan2(position.y(), position.x());
  if (distance < same_point && (state_.incremental || words_.angle == nullptr)) {
    report(Severity::error, "polar-words", 1, first.column, [&] {
      return Text{"the tool is at X0 Y0, where it has no angle",
                  "angle zero is taken; write both @ and ^ with G90"};
    });
    angle = 0;
  }
  if (words_.distance != nullptr) {
    const double value = state_.to_mm(words_.distance->value);
    distance = state_.incremental ? distance + value : value;
  }
  if (words_.angle != nullptr) {
    const double value = units::from_deg(words_.angle->value);
    angle = state_.incremental ? angle + value : value;
  }
  target.x() = distance * std::cos(angle);
  target.y() = distance * std::sin(angle);
  return target;
}

}  // namespace feedscope
