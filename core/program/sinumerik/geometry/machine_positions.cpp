#include "core/program/sinumerik/geometry/machine_positions.h"

#include <array>

namespace feedscope::sinumerik {

/// Tools are changed at the first fixed point.
AxisPlace MachinePositions::place_of(std::size_t axis) const {
  const Function* const own = functions_.own_block;
  const char letter = coordinate_names[axis];
  if (own == nullptr && words_.has(letter) && !modal_.is_incremental(words_[letter])) {
    return {AxisPlace::Kind::machine, to_mm(words_[letter].value)};
  }
  if (own != nullptr && own->name == "G74") {
    return {.kind = AxisPlace::Kind::home};
  }
  if (own != nullptr && own->name == "G75" && functions_.fixed_point == 1) {
    return {.kind = AxisPlace::Kind::tool_change};
  }
  return {.kind = AxisPlace::Kind::unknown};
}

void MachinePositions::move() {
  const bool by_coordinate = functions_.own_block == nullptr;
  std::array<bool, 3> named{};
  AxisPlaces places;
  for (std::size_t axis = 0; axis < named.size(); ++axis) {
    named[axis] = words_.has(coordinate_names[axis]) || !words_.has_any("XYZ");
    places[axis] = place_of(axis);
  }
  const bool at_feed =
      by_coordinate && modal_.moves_at_feed() && path().feed_mode() != FeedMode::inverse_time;
  path_modes_.use(!at_feed);
  if (path().go_to_machine_place(named, places, at_feed ? path().feed_rate() : 0)) {
    return;
  }
  machining_.report_machine_move(by_coordinate ? functions_.machine_axes->name : functions_.own_block->name,
                                 "machine-position",
                                 by_coordinate ? words_.first_column("XYZ") : functions_.own_column);
}

}  // namespace feedscope::sinumerik
