#pragma once

#include <array>

#include "core/base/geometry.h"
#include "core/program/machine_move.h"
#include "core/program/path/coordinate_frame.h"

namespace feedscope {

/// Which coordinates a line of the program names, and how.
struct ProgrammedAxes {
  std::array<bool, 3> named{};
  std::array<bool, 3> absolute{};     ///< of those: with the coordinate itself
  std::array<bool, 3> incremental{};  ///< of those: with a distance from where the axis is
};

/// Follows where the axes are when a program sends them to places that only the machine knows, until it says
/// where each of them is again. Coordinates are those that are shown.
class PlaceTracker {
 public:
  bool all_shown() const { return all_shown_; }
  bool is_shown(int axis) const { return places_[static_cast<std::size_t>(axis)].is_shown(); }
  /// Meaningful while not all_shown().
  const AxisPlaces& places() const { return places_; }
  /// Where the axes are, which the path shows at `shown` [mm].
  AxisPlaces places_at(const Vec3& shown) const;

  /// The axes `moved` go to `to`; `shown`: where the others are.
  void go_to(const std::array<bool, 3>& moved, const AxisPlaces& to, const Vec3& shown);
  /// The tool moves by a block with the words `axes` from `from` to `to`, in programmed coordinates of
  /// `frame`. An axis is known from then on where it was named with its coordinate, or moves without being
  /// named by a distance, as in cycles.
  void move(const CoordinateFrame& frame, const ProgrammedAxes& axes, const Vec3& from, const Vec3& to);
  /// Of the axes `these`, those that are not known are where the path shows them.
  void assume(const Vec3& shown, const std::array<bool, 3>& these = {true, true, true});

 private:
  void update();

  AxisPlaces places_;
  bool all_shown_ = true;
};

}  // namespace feedscope
