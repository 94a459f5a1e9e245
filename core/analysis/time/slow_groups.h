#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/time/slow_places.h"
#include "core/base/dimension.h"

namespace feedscope {

/// Shape of the path where a run is slowest.
enum class PlaceShape : std::uint8_t {
  corner,  ///< a junction that is not tangent, or the curve that the control puts there
  arc,
  line,   ///< within a line, or at a tangent junction of lines
  curve,  ///< a smooth curve of the compressor
  rapid,
  stop,  ///< start or end of the program, or a dwell
};
inline constexpr std::size_t place_shape_count = static_cast<std::size_t>(PlaceShape::stop) + 1;

/// Data of a shape.
struct PlaceShapeInfo {
  std::string_view key;      ///< for files: "corner", "arc", ...
  std::string_view title;    ///< for people: "corners"
  std::string_view measure;  ///< title of SlowGroup::median: "turn", "radius", "block length"; "" without one
  Dimension dimension = Dimension::length;  ///< of the measure
};
const PlaceShapeInfo& info_of(PlaceShape shape);

/// Slow places of one shape that lose at least a hundredth of their time to one kind of cause, and the total
/// loss to that kind on this shape. Gains by the same cause elsewhere are subtracted from the loss.
struct SlowGroup {
  PlaceShape shape = PlaceShape::line;
  CauseKind kind = CauseKind::programmed_feed;
  Cause cause;                   ///< of this kind, with the axis if one takes nearly all of the loss
  std::size_t count = 0;         ///< of these places
  double loss = 0;               ///< to this kind, at these places and others of the shape; above 0 [s]
  std::uint32_t first_line = 0;  ///< smallest source line of all
  std::uint32_t last_line = 0;   ///< largest
  double smallest = 0;           ///< turn of corners [rad], radius of arcs [mm], length of blocks [mm]
  double median = 0;
  double largest = 0;
  std::vector<SlowPlace>
      worst;  ///< largest loss to this kind first, with that loss; at most worst_places of them
};

/// Cause of the loss of a group, for display: cause_title(), except "slowing for a lower programmed feed",
/// since no time is lost at the programmed feed itself.
std::string lost_to(const SlowGroup& group);

struct SlowGroups {
  static constexpr std::size_t worst_places = 20;

  std::vector<SlowGroup> groups;  ///< largest loss first
  double loss = 0;                ///< as SlowPlaces::loss [s]
  double other = 0;               ///< part of `loss` in no group: too small for a place, or gained [s]
};

/// Cost of find_slow_places and a search of the pieces for each place. Throws Cancelled.
SlowGroups find_slow_groups(const Trajectory& trajectory, Progress* progress = nullptr);

}  // namespace feedscope
