// The part of IsoReader that reads G16: radius and angle instead of the plane's two coordinates.
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

}  // namespace feedscope
