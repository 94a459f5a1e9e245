#pragma once

#include <array>

#include "core/base/geometry.h"
#include "core/program/machine_move.h"
#include "core/program/path/coordinate_frame.h"

namespace feedscope {

/// Coordinates that a line of the program names, absolute or incremental.
struct ProgrammedAxes {
  std::array<bool, 3> named{};
  std::array<bool, 3> absolute{};     ///< of those: by the coordinate itself
  std::array<bool, 3> incremental{};  ///< of those: by a distance
};

/// Tracks the axes that a program sends to places that only the machine knows, until it gives each of them a
/// coordinate again. Coordinates are shown ones.
class PlaceTracker {
 public:
  bool all_shown() const { return all_shown_; }
  bool is_shown(int axis) const { return places_[static_cast<std::size_t>(axis)].is_shown(); }
  /// Meaningful while not all_shown().
  const AxisPlaces& places() const { return places_; }
  /// Places of the axes, which the path shows at `shown` [mm].
  AxisPlaces places_at(const Vec3& shown) const;

  /// Sends the axes `moved` to `to`; `shown`: place of the others.
  void go_to(const std::array<bool, 3>& moved, const AxisPlaces& to, const Vec3& shown);
  /// Moves the tool by a block with the words `axes` from `from` to `to`, in programmed coordinates of
  /// `frame`. From then on an axis is known if it was named with its coordinate, or if it moves without a
  /// distance word, as in cycles.
  void move(const CoordinateFrame& frame, const ProgrammedAxes& axes, const Vec3& from, const Vec3& to);
  /// Assumes for the unknown ones of the axes `these` that they are at their shown place.
  void assume(const Vec3& shown, const std::array<bool, 3>& these = {true, true, true});

 private:
  void update();

  AxisPlaces places_;
  bool all_shown_ = true;
};

}  // namespace feedscope
