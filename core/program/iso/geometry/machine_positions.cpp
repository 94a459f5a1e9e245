#include "core/program/iso/geometry/machine_positions.h"

#include "core/program/text/message.h"

namespace feedscope::iso {

void MachinePositions::run(int code, std::uint32_t column) {
  switch (code) {
    case 280:
    case 300:
      go_to_reference(code, column);
      break;
    case 281:
    case 301:
      store(code);
      break;
    case 290:
      is_linuxcnc() ? report_levelling(column) : return_from_reference();
      break;
    default:
      go_to_machine_coordinates(column);
      break;
  }
}

/// LinuxCNC and grbl store the current axis positions. With axes it is a word of other controls.
void MachinePositions::store(int code) {
  if (!words_.has_any("XYZ")) {
    stored_[code == 281 ? 0 : 1] = path().places();
  }
}

AxisPlaces MachinePositions::reference_of(int code) const {
  const bool second = code == 300;
  if (const std::optional<AxisPlaces>& stored = stored_[second ? 1 : 0]) {
    return *stored;
  }
  constexpr int second_reference = 2;
  AxisPlace place{.kind = AxisPlace::Kind::home};
  if (second) {
    const bool is_known = !words_.has('P') || words_['P'].value == second_reference;
    place.kind = is_known ? AxisPlace::Kind::tool_change : AxisPlace::Kind::unknown;
  }
  return {place, place, place};
}

void MachinePositions::go_to_reference(int code, std::uint32_t column) {
  if (words_.has_any(axis_letters)) {
    intermediate_point_ = targets_.target();
    targets_.program_axes();
    if ((intermediate_point_ - path().position()).norm() > same_point) {
      path().rapid(intermediate_point_);
    }
  }
  if (!path().go_to_machine_place(targets_.named_axes(), reference_of(code))) {
    machining_.report_machine_move(g_name(code), "reference-point", column);
  }
}

void MachinePositions::go_to_machine_coordinates(std::uint32_t column) {
  if (!words_.has_any("XYZ")) {
    return;
  }
  const Vec3 target = targets_.axes(Vec3::Zero());
  AxisPlaces places;
  for (std::size_t axis = 0; axis < places.size(); ++axis) {
    places[axis] = {AxisPlace::Kind::machine, target[static_cast<Eigen::Index>(axis)]};
  }
  const bool at_feed = modal_.motion == MotionMode::line && path().feed_mode() != FeedMode::inverse_time;
  if (!path().go_to_machine_place(targets_.named_axes(), places, at_feed ? path().feed_rate() : 0)) {
    machining_.report_machine_move("G53", "machine-position", column);
  }
}

void MachinePositions::return_from_reference() {
  const Vec3 target = targets_.target();
  targets_.program_axes();
  if ((intermediate_point_ - path().position()).norm() > same_point) {
    path().rapid(intermediate_point_);
  }
  path().rapid(target);
}

void MachinePositions::report_levelling(std::uint32_t column) const {
  report(Severity::info, "unread-g", 290, column, [] {
    return Text{NC_("core", "G29 (bed levelling of printers) is not supported"),
                NC_("core", "nothing moves")};
  });
}

}  // namespace feedscope::iso
