#include "core/program/sinumerik/geometry/targets.h"

#include <cmath>

#include "core/base/units.h"

namespace feedscope::sinumerik {

bool Targets::is_diameter(const BlockWords::Value& word) const {
  switch (word.across) {
    case Across::diameter:
      return true;
    case Across::radius:
      return false;
    case Across::modal:
      break;
  }
  return modes_.diameters == Action::diameters ||
         (modes_.diameters == Action::diameters_if_absolute && !modal_.is_incremental(word));
}

Vec3 Targets::target(const Vec3& start) const {
  Vec3 target = start;
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = coordinate_names[static_cast<std::size_t>(axis)];
    if (!words_.has(letter)) {
      continue;
    }
    const BlockWords::Value& word = words_[letter];
    const double value = to_mm(axis == 0 && is_diameter(word) ? word.value / 2 : word.value);
    target[axis] = modal_.is_incremental(word) ? increment_base(axis, start) + value : value;
  }
  if (words_.is_polar()) {
    target = polar_target(target);
  }
  if (words_.has(Address::ang)) {
    angle_target(target);
  }
  return target;
}

/// Start of an increment of the axis. After a change of frame, that is the previous coordinate in the new
/// frame: the increment also traverses the change, as with the control's setting data 42440 at its default of
/// 1 (Function Manual K2, frames with G91).
double Targets::increment_base(int axis, const Vec3& start) const {
  const std::optional<double>& kept = kept_coordinates_[static_cast<std::size_t>(axis)];
  if (!kept || std::abs(*kept - start[axis]) <= same_point) {
    return start[axis];
  }
  const char letter = coordinate_names[static_cast<std::size_t>(axis)];
  report(Severity::info, "frame-increment", letter, words_[letter].column, [&] {
    return Text{
        message(
            NC_("core", "an increment of {} after a change of frame also traverses the change, {:.6g} mm"),
            letter, *kept - start[axis]),
        NC_("core", "as on controls with setting data 42440 at 1, the default; else program it absolute")};
  });
  return *kept;
}

Vec3 Targets::center() const {
  constexpr std::array<char, 3> center_letters{'I', 'J', 'K'};
  Vec3 center = path().position();
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = center_letters[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      const double value = to_mm(words_[letter].value);
      const Reading reading = words_[letter].reading;
      const bool absolute = reading != Reading::modal && reading != Reading::incremental;
      center[axis] = absolute ? value : center[axis] + value;
    }
  }
  return center;
}

void Targets::program_axes() {
  const bool polar = words_.is_polar();
  if (polar) {
    modes_.polar = polar_of_block();
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (words_.has(coordinate_names[static_cast<std::size_t>(axis)]) ||
        (polar && axis != normal_axis(modal_.plane))) {
      program_axis(axis);
    }
  }
}

void Targets::program_axis(int axis) {
  const char letter = coordinate_names[static_cast<std::size_t>(axis)];
  path().program_axis(axis, words_.has(letter) && modal_.is_incremental(words_[letter]));
  kept_coordinates_[static_cast<std::size_t>(axis)].reset();
}

void Targets::keep_coordinates() {
  for (int axis = 0; axis < 3; ++axis) {
    std::optional<double>& kept = kept_coordinates_[static_cast<std::size_t>(axis)];
    kept = kept.value_or(path().position()[axis]);
  }
}

/// AP and RP about the pole; the axis across the plane as in the other words. Both are modal, AP up to a new
/// pole or plane; a missing one is that of the start (Programming Manual NC, 2.9.3.2).
Targets::Polar Targets::polar_of_block() const {
  const Polar& polar = modes_.polar;
  const Vec3 from = path().position() - modes_.pole;
  const double across = from[second_axis(modal_.plane)];
  const double along = from[first_axis(modal_.plane)];
  double angle = polar.angle.value_or(std::atan2(across, along));
  double radius = polar.radius.value_or(std::hypot(along, across));
  if (words_.has(Address::ap)) {
    const BlockWords::Value& word = words_[Address::ap];
    angle = (modal_.is_incremental(word) ? angle : 0) + units::from_deg(word.value);
  }
  if (words_.has(Address::rp)) {
    const BlockWords::Value& word = words_[Address::rp];
    radius = (word.reading == Reading::incremental ? radius : 0) + to_mm(word.value);
  }
  return {.angle = angle, .radius = radius};
}

Vec3 Targets::polar_target(const Vec3& straight_target) const {
  const int first = first_axis(modal_.plane);
  const int second = second_axis(modal_.plane);
  const Polar polar = polar_of_block();
  Vec3 target = straight_target;
  target[first] = modes_.pole[first] + *polar.radius * std::cos(*polar.angle);
  target[second] = modes_.pole[second] + *polar.radius * std::sin(*polar.angle);
  return target;
}

/// ANG: a line at an angle to the plane's first axis, one of its coordinates given.
void Targets::angle_target(Vec3& target) const {
  const int first = first_axis(modal_.plane);
  const int second = second_axis(modal_.plane);
  const bool has_first = words_.has(coordinate_names[static_cast<std::size_t>(first)]);
  const bool has_second = words_.has(coordinate_names[static_cast<std::size_t>(second)]);
  const double angle = units::from_deg(words_[Address::ang].value);
  const double along = std::cos(angle);
  const double across = std::sin(angle);
  constexpr double parallel = 1e-9;
  const double divisor = has_first ? along : across;
  if (has_first == has_second || std::abs(divisor) < parallel) {
    report(Severity::error, "line-angle", 0, words_[Address::ang].column, [&] {
      const double degrees = words_[Address::ang].value;
      return Text{has_first == has_second
                      ? message(NC_("core", "ANG={} needs exactly one coordinate of the plane"), degrees)
                      : message(NC_("core", "a line at ANG={} does not reach the given coordinate"), degrees),
                  NC_("core", "the line ends at the given coordinates; program its end")};
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

void Targets::set_pole() {
  const Action action = functions_.own_block->action;
  Vec3 pole = action == Action::pole_from_position ? path().position()
              : action == Action::pole_from_pole   ? modes_.pole
                                                   : Vec3(Vec3::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = coordinate_names[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      pole[axis] += to_mm(words_[letter].value);
    }
  }
  if (words_.has(Address::ap) && words_.has(Address::rp)) {
    const double angle = units::from_deg(words_[Address::ap].value);
    const double radius = to_mm(words_[Address::rp].value);
    pole[first_axis(modal_.plane)] += radius * std::cos(angle);
    pole[second_axis(modal_.plane)] += radius * std::sin(angle);
  }
  modes_.pole = pole;
  modes_.polar.angle.reset();
}

}  // namespace feedscope::sinumerik
