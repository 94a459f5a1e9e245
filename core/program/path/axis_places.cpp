#include "core/program/path/axis_places.h"

#include <algorithm>

namespace feedscope {

void PlaceTracker::go_to(const std::array<bool, 3>& moved, const AxisPlaces& to, const Vec3& shown) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (moved[axis]) {
      places_[axis] = to[axis];
    } else if (places_[axis].is_shown()) {
      places_[axis] = {AxisPlace::Kind::part, shown[static_cast<Eigen::Index>(axis)]};
    }
  }
  update();
}

void PlaceTracker::move(const CoordinateFrame& frame, const ProgrammedAxes& axes, const Vec3& from,
                        const Vec3& to) {
  std::array<bool, 3> moves{};
  std::array<bool, 3> known{};  // in programmed coordinates, after the block
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const bool changes = to[axis] != from[axis];
    moves[i] = axes.absolute[i] || changes;
    known[i] = axes.absolute[i] || (changes && !axes.incremental[i]);
    if (!known[i]) {
      known[i] = true;
      for (int shown = 0; shown < 3; ++shown) {
        known[i] = known[i] && (is_shown(shown) || !frame.is_programmed_by(axis, shown));
      }
    }
  }
  const Vec3 end = frame.to_shown(to);
  const Vec3 way = end - frame.to_shown(from);
  for (int shown = 0; shown < 3; ++shown) {
    bool moved = false;
    bool all_known = true;
    for (int axis = 0; axis < 3; ++axis) {
      if (frame.is_shown_by(shown, axis)) {
        moved = moved || moves[static_cast<std::size_t>(axis)];
        all_known = all_known && known[static_cast<std::size_t>(axis)];
      }
    }
    AxisPlace& place = places_[static_cast<std::size_t>(shown)];
    if (moved && all_known) {
      place = {AxisPlace::Kind::part, end[shown]};
    } else if (moved && frame.is_shift()) {
      place.value += way[shown];
    } else if (moved) {
      place = {AxisPlace::Kind::unknown, 0};
    }
  }
  update();
}

AxisPlaces PlaceTracker::places_at(const Vec3& shown) const {
  AxisPlaces at = places_;
  for (int axis = 0; axis < 3; ++axis) {
    if (is_shown(axis)) {
      at[static_cast<std::size_t>(axis)] = {AxisPlace::Kind::part, shown[axis]};
    }
  }
  return at;
}

void PlaceTracker::assume(const Vec3& shown, const std::array<bool, 3>& these) {
  for (int axis = 0; axis < 3; ++axis) {
    AxisPlace& place = places_[static_cast<std::size_t>(axis)];
    if (!place.is_shown() && these[static_cast<std::size_t>(axis)]) {
      place = {AxisPlace::Kind::assumed, shown[axis]};
    }
  }
  update();
}

void PlaceTracker::update() {
  all_shown_ =
      std::all_of(places_.begin(), places_.end(), [](const AxisPlace& place) { return place.is_shown(); });
}

}  // namespace feedscope
