#include "core/program/sinumerik/geometry/coordinates.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "core/base/units.h"
#include "core/program/text/message.h"

namespace feedscope::sinumerik {

namespace {

/// Number of a settable frame by its G word: G500 is 0, G54 is 1, G505 is 5.
int frame_number(int g) {
  return g >= 500 ? g - 500 : g - 53;
}

}  // namespace

Coordinates::Coordinates(Context& context, Targets& targets, Splines& splines)
    : Part(context), targets_(targets), splines_(splines) {
  use_given_offsets();
}

void Coordinates::use_given_offsets() {
  for (const auto& [name, zero] : machining_.options.offsets.all()) {
    const int g =
        name.find_first_not_of("0123456789", 1) == std::string::npos ? std::stoi(name.substr(1)) : 0;
    const int number = frame_number(g);
    if (g >= 54 && number > 0) {
      FrameValue& frame = settable_[number];
      for (int axis = 0; axis < 3; ++axis) {
        frame.set(FrameValue::Part::shift, axis, zero[axis]);
      }
    }
  }
}

void Coordinates::run() {
  Frames& frames = modes_.frames;
  const Action action = functions_.own_block->action;
  switch (action) {
    case Action::shift:
      frames.replace(CoordinateFrame::shift(shift()));
      break;
    case Action::shift_more:
      frames.add(CoordinateFrame::shift(shift()));
      break;
    case Action::turn:
      frames.replace(turned_about(angles()));
      break;
    case Action::turn_more:
      frames.add(turned_about(angles()));
      break;
    case Action::scale:
      frames.replace(scale());
      break;
    case Action::scale_more:
      frames.add(scale());
      break;
    case Action::mirror:
      frames.replace(mirror());
      break;
    case Action::mirror_more:
      frames.add(mirror());
      break;
    case Action::coarse_shift:
    case Action::fine_shift:
      for (int axis = 0; axis < 3; ++axis) {
        const char letter = coordinate_names[static_cast<std::size_t>(axis)];
        if (words_.has(letter)) {
          frames.set_shift(axis, to_mm(words_[letter].value), action == Action::fine_shift);
        }
      }
      break;
    default:
      return;
  }
  set_frame();
}

/// X Y Z of the block as written.
Vec3 Coordinates::values(double missing) const {
  Vec3 values = Vec3::Constant(missing);
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = coordinate_names[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      values[axis] = words_[letter].value;
    }
  }
  return values;
}

/// Angles of the block [rad]; RPL turns in the plane.
Vec3 Coordinates::angles() const {
  Vec3 angles = values(0);
  if (words_.has(Address::rpl)) {
    angles[normal_axis(modal_.plane)] = words_[Address::rpl].value;
  }
  return angles * (units::pi / 180);
}

CoordinateFrame Coordinates::scale() const {
  Vec3 factors = values(1);
  if ((factors.array() == 0).any()) {
    report(Severity::error, "scale-factor", 0, functions_.own_column, [] {
      return Text{NC_("core", "a scale factor is zero"),
                  NC_("core", "1 is used; write a factor other than zero")};
    });
    factors = (factors.array() == 0).select(1, factors);
  }
  return CoordinateFrame::scale(factors);
}

CoordinateFrame Coordinates::mirror() const {
  Vec3 factors = Vec3::Ones();
  for (int axis = 0; axis < 3; ++axis) {
    factors[axis] = words_.has(coordinate_names[static_cast<std::size_t>(axis)]) ? -1 : 1;
  }
  return CoordinateFrame::scale(factors);
}

void Coordinates::set_frame() {
  constexpr double max_size = 1e12;
  const CoordinateFrame frame = modes_.frames.frame();
  const auto within = [](const Vec3& point) { return point.allFinite() && point.norm() < max_size; };
  if (within(frame.to_shown(Vec3::Ones())) && within(frame.to_programmed(Vec3::Ones()))) {
    targets_.keep_coordinates();
    path().set_frame(frame);
    return;
  }
  report(Severity::error, "frame-range", 0, functions_.own_column, [] {
    return Text{NC_("core", "the combined frames are out of range"),
                NC_("core", "all of them are reset; check additive frames in loops")};
  });
  modes_.frames = {};
  path().set_frame({});
}

void Coordinates::select_work_offset(int g, std::uint32_t column) {
  const int before = modes_.work_offset;
  modes_.work_offset = g;
  const auto known = [this](int number) { return settable_.find(frame_number(number)); };
  const auto found = known(g);
  const bool given = found != settable_.end() && (before == 0 || known(before) != settable_.end());
  if (path().has_moved() && before != 0 && before != g && !given) {
    report(Severity::warning, "work-offset", g, column, [&] {
      return Text{message(NC_("core", "G{} is selected after motion in G{}"), g, before),
                  missing_offset_hint(fmt::format("G{}", found != settable_.end() ? before : g))};
    });
  }
  constexpr int suppressed = 500;
  std::optional<Vec3> zero = g == suppressed ? std::optional<Vec3>(Vec3::Zero()) : std::nullopt;
  if (found != settable_.end()) {
    zero = found->second.frame().to_shown(Vec3::Zero());
  }
  path().use_work_offset(fmt::format("G{}", g), zero);
  if (!settable_.empty()) {
    set_settable_in_force(found == settable_.end() ? FrameValue() : found->second);
  }
}

void Coordinates::swivel(const CoordinateFrame& plane, bool additive) {
  modes_.frames.set_swivel(additive ? modes_.frames.swivel() * plane : plane);
  set_frame();
}

void Coordinates::set_programmed(const CoordinateFrame& frame) {
  modes_.frames.replace(frame);
  set_frame();
}

void Coordinates::set_programmed_shift(int axis, double value, bool fine) {
  modes_.frames.set_shift(axis, value, fine);
  set_frame();
}

FrameValue Coordinates::settable(int number) const {
  const auto found = settable_.find(number);
  return found == settable_.end() ? FrameValue() : found->second;
}

void Coordinates::set_settable_in_force(const FrameValue& value) {
  splines_.finish();
  in_force_ = value;
  modes_.frames.set_settable(value.frame());
  path().set_machine_axes(value.set_by_program);
  set_frame();
}

void Coordinates::restore(const Modes& modes) {
  modes_ = modes;
  set_frame();
}

}  // namespace feedscope::sinumerik
