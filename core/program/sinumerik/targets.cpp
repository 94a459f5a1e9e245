// The part of SinumerikReader that says where a block goes: Cartesian, polar, by an angle.
#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/program/sinumerik/sinumerik_reader.h"

namespace feedscope {

using namespace sinumerik;

bool SinumerikReader::is_incremental(const BlockWords::Value& word) const {
  return word.reading == Reading::incremental || (word.reading == Reading::modal && modal_.incremental);
}

bool SinumerikReader::is_diameter(const BlockWords::Value& word) const {
  switch (word.across) {
    case Across::diameter:
      return true;
    case Across::radius:
      return false;
    case Across::modal:
      break;
  }
  return modal_.diameters == Action::diameters ||
         (modal_.diameters == Action::diameters_if_absolute && !is_incremental(word));
}

Vec3 SinumerikReader::target_of_block() {
  const Vec3 start = spline_.begun() ? spline_.last().at : path().position();
  Vec3 target = start;
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_names[static_cast<std::size_t>(axis)];
    if (!words_.has(letter)) {
      continue;
    }
    const BlockWords::Value& word = words_[letter];
    const double value = to_mm(axis == 0 && is_diameter(word) ? word.value / 2 : word.value);
    target[axis] = is_incremental(word) ? increment_base(axis, start) + value : value;
  }
  if (words_.has(Address::ap) || words_.has(Address::rp)) {
    target = polar_target(target);
  }
  if (words_.has(Address::ang)) {
    angle_target(target);
  }
  return target;
}

/// Where an increment of the axis counts from. Once a frame has changed, that is the coordinate of before in
/// the new frame: the change is traversed with the increment, as with the control's setting data 42440 at its
/// default of 1 (Function Manual K2, frames with G91).
double SinumerikReader::increment_base(int axis, const Vec3& start) {
  const std::optional<double>& kept = kept_coordinates_[static_cast<std::size_t>(axis)];
  if (!kept || std::abs(*kept - start[axis]) <= same_point) {
    return start[axis];
  }
  const char letter = axis_names[static_cast<std::size_t>(axis)];
  report(Severity::info, "frame-increment", letter, words_[letter].column, [&] {
    return Text{fmt::format("{} by an increment after a change of frame traverses the change, {:.6g} mm, too",
                            letter, *kept - start[axis]),
                "as controls do whose setting data 42440 is 1, the default; else write it absolute"};
  });
  return *kept;
}

/// The block has said where these axes are in the frame in force.
void SinumerikReader::program_axis(int axis) {
  const char letter = axis_names[static_cast<std::size_t>(axis)];
  path().program_axis(axis, words_.has(letter) && is_incremental(words_[letter]));
  kept_coordinates_[static_cast<std::size_t>(axis)].reset();
}

/// AP and RP about the pole; the axis across the plane as in the other words. Both stay in force, AP up to a
/// new pole or plane; where one is missing, it is that of the start (Programming Manual NC, 2.9.3.2).
SinumerikReader::Polar SinumerikReader::polar_of_block() const {
  const Vec3 from = path().position() - modal_.pole;
  const double across = from[second_axis(modal_.plane)];
  const double along = from[first_axis(modal_.plane)];
  double angle = modal_.polar.angle.value_or(std::atan2(across, along));
  double radius = modal_.polar.radius.value_or(std::hypot(along, across));
  if (words_.has(Address::ap)) {
    const BlockWords::Value& word = words_[Address::ap];
    angle = (is_incremental(word) ? angle : 0) + units::from_deg(word.value);
  }
  if (words_.has(Address::rp)) {
    const BlockWords::Value& word = words_[Address::rp];
    radius = (word.reading == Reading::incremental ? radius : 0) + to_mm(word.value);
  }
  return {.angle = angle, .radius = radius};
}

Vec3 SinumerikReader::polar_target(const Vec3& straight_target) const {
  const int first = first_axis(modal_.plane);
  const int second = second_axis(modal_.plane);
  const Polar polar = polar_of_block();
  Vec3 target = straight_target;
  target[first] = modal_.pole[first] + *polar.radius * std::cos(*polar.angle);
  target[second] = modal_.pole[second] + *polar.radius * std::sin(*polar.angle);
  return target;
}

/// ANG: a line at an angle to the plane's first axis, one of its coordinates given.
void SinumerikReader::angle_target(Vec3& target) {
  const int first = first_axis(modal_.plane);
  const int second = second_axis(modal_.plane);
  const bool has_first = words_.has(axis_names[static_cast<std::size_t>(first)]);
  const bool has_second = words_.has(axis_names[static_cast<std::size_t>(second)]);
  const double angle = units::from_deg(words_[Address::ang].value);
  const double along = std::cos(angle);
  const double across = std::sin(angle);
  constexpr double parallel = 1e-9;
  const double divisor = has_first ? along : across;
  if (has_first == has_second || std::abs(divisor) < parallel) {
    report(Severity::error, "line-angle", 0, words_[Address::ang].column, [&] {
      return Text{fmt::format("ANG={} with {} is not read", words_[Address::ang].value,
                              has_first == has_second ? "none or both coordinates of the plane"
                                                      : "this coordinate, which it never reaches,"),
                  "the line ends at the coordinates that are given; write its end"};
    });
    return;
  }
  const Vec3 start = path().position();
  if (has_first) {
    target[second] = start[second] + (target[first] - start[first]) * across / along;
  } else {
    target[first] = start[first] + (target[second] - start[second]) * along / across;
  }
}

}  // namespace feedscope
