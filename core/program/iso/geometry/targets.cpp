#include "core/program/iso/geometry/targets.h"

#include <cmath>

#include "core/base/units.h"

namespace feedscope::iso {

Vec3 Targets::target() {
  const Vec3 position = path().position();
  if (!words_.has_any("XYZ") && !words_.has_polar()) {
    return position;
  }
  const Vec3 target = target_from(position);
  if (words_.has_polar()) {
    return distance_and_angle_target(target);
  }
  return polar_.on ? polar_target(target) : target;
}

Vec3 Targets::target_from(const Vec3& place) const {
  return modal_.incremental ? Vec3(place + axes(Vec3::Zero())) : axes(place);
}

Vec3 Targets::axes(const Vec3& otherwise) const {
  Vec3 values = otherwise;
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_letters[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      values[axis] = length(letter);
    }
  }
  return values;
}

Vec3 Targets::center(bool absolute) const {
  Vec3 center = path().position();
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = center_letters[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      const double value = length(letter);
      center[axis] = absolute ? value : center[axis] + value;
    }
  }
  return center;
}

std::array<bool, 3> Targets::named_axes() const {
  std::array<bool, 3> named{};
  for (std::size_t axis = 0; axis < named.size(); ++axis) {
    named[axis] = words_.has(axis_letters[axis]) || !words_.has_any("XYZ");
  }
  return named;
}

void Targets::program_axes() const {
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_letters[static_cast<std::size_t>(axis)];
    if (words_.has(letter) || (words_.has_polar() && axis < 2)) {
      path().program_axis(axis, modal_.incremental && words_.has(letter));
      check_point(letter, implausible_length);
    }
  }
}

void Targets::check_point(char letter, double implausible) const {
  constexpr double mm_taken_for_an_inch = 25;
  const Word& word = words_[letter];
  if (is_linuxcnc() || !words_.has(letter) || word.has_point ||
      std::abs(word.value) < (modal_.inch ? implausible / mm_taken_for_an_inch : implausible)) {
    return;
  }
  report(Severity::warning, "decimal-point", 0, word.column, [&] {
    return Text{modal_.inch ? message(NC_("core", "{}{:.0f} without a decimal point is used as {:.0f} inch"),
                                      letter, word.value, word.value)
                            : message(NC_("core", "{}{:.0f} without a decimal point is used as {:.0f} mm"),
                                      letter, word.value, word.value),
                modal_.inch
                    ? NC_("core", "many controls use it in units of 0.0001 inch; write a decimal point")
                    : NC_("core", "many controls use it in units of 0.001 mm; write a decimal point")};
  });
}

Vec3 Targets::polar_target(Vec3 target) {
  const int first = first_axis(modal_.plane);
  const int second = second_axis(modal_.plane);
  const char radius = axis_letters[static_cast<std::size_t>(first)];
  const char angle = axis_letters[static_cast<std::size_t>(second)];
  if (!words_.has(radius) && !words_.has(angle)) {
    return target;
  }
  if (words_.has(radius)) {
    polar_.radius = length(radius);
    polar_.center = modal_.incremental ? path().position() : Vec3(Vec3::Zero());
  }
  if (words_.has(angle)) {
    const double turn = units::from_deg(words_[angle].value);
    polar_.angle = modal_.incremental ? polar_.angle + turn : turn;
  }
  target[first] = polar_.center[first] + polar_.radius * std::cos(polar_.angle);
  target[second] = polar_.center[second] + polar_.radius * std::sin(polar_.angle);
  return target;
}

Vec3 Targets::distance_and_angle_target(Vec3 target) const {
  const Word& first = words_.distance != nullptr ? *words_.distance : *words_.angle;
  if (words_.has_any("XY")) {
    report(Severity::error, "polar-words", 0, first.column, [&] {
      return Text{message(NC_("core", "{} in a block with X or Y"), first.letter),
                  NC_("core", "X and Y are ignored; write either of them")};
    });
  }
  const Vec3 position = path().position();
  double distance = std::hypot(position.x(), position.y());
  double angle = std::atan2(position.y(), position.x());
  if (distance < same_point && (modal_.incremental || words_.angle == nullptr)) {
    report(Severity::error, "polar-words", 1, first.column, [] {
      return Text{NC_("core", "the tool is at X0 Y0, where it has no angle"),
                  NC_("core", "angle zero is used; write both @ and ^ with G90")};
    });
    angle = 0;
  }
  if (words_.distance != nullptr) {
    const double value = modal_.to_mm(words_.distance->value);
    distance = modal_.incremental ? distance + value : value;
  }
  if (words_.angle != nullptr) {
    const double value = units::from_deg(words_.angle->value);
    angle = modal_.incremental ? angle + value : value;
  }
  target.x() = distance * std::cos(angle);
  target.y() = distance * std::sin(angle);
  return target;
}

}  // namespace feedscope::iso
