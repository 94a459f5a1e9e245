#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/slow_places.h"
#include "core/base/dimension.h"

namespace feedscope {

/// What the path is like where a run is slowest.
enum class PlaceShape : std::uint8_t {
  corner,  ///< where blocks meet that are not tangent, or the curve that the control puts there
  arc,
  line,   ///< within a line, or where tangent lines meet
  curve,  ///< a smooth curve of the compressor
  rapid,
  stop,  ///< start or end of the program, or a dwell
};
inline constexpr std::size_t place_shape_count = static_cast<std::size_t>(PlaceShape::stop) + 1;

/// What is known of a shape.
struct PlaceShapeInfo {
  std::string_view key;      ///< for files: "corner", "arc", ...
  std::string_view title;    ///< for people: "corners"
  std::string_view measure;  ///< what SlowGroup::median is: "turn", "radius", "block length"; "" for nothing
  Dimension dimension = Dimension::length;  ///< of it
};
const PlaceShapeInfo& info_of(PlaceShape shape);

/// Slow places of one shape that lose a hundredth of their time or more to one kind of cause, and what that
/// kind loses where the path has this shape. What is gained by the same cause elsewhere is taken from the
/// loss.
struct SlowGroup {
  PlaceShape shape = PlaceShape::line;
  CauseKind kind = CauseKind::programmed_feed;
  Cause cause;  ///< of this kind, with the axis that nearly all is lost to; without where it is several
  std::size_t count = 0;         ///< of these places
  double loss = 0;               ///< to this kind, at these places and at others of the shape; above 0 [s]
  std::uint32_t first_line = 0;  ///< least source line of all
  std::uint32_t last_line = 0;   ///< largest
  double smallest = 0;  ///< turn of the corners [rad], radius of the arcs [mm], length of the blocks [mm]
  double median = 0;
  double largest = 0;
  std::vector<SlowPlace>
      worst;  ///< those that lose most to this kind first, with that loss; at most worst_places
};

/// What the places of a group lose their time to, for people: cause_title(), but for the programmed feed
/// "slowing for a lower programmed feed", as no time is lost at the programmed feed itself.
std::string lost_to(const SlowGroup& group);

struct SlowGroups {
  static constexpr std::size_t worst_places = 20;

  std::vector<SlowGroup> groups;  ///< that which loses most first
  double loss = 0;                ///< as SlowPlaces::loss [s]
  double other = 0;               ///< of `loss`: in no group: too small to be a place, or gained [s]
};

/// Cost of find_slow_places and a search of the pieces for each place. Throws Cancelled.
SlowGroups find_slow_groups(const Trajectory& trajectory, Progress* progress = nullptr);

}  // namespace feedscope
