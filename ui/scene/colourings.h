#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/run/quantity.h"

namespace feedscope::ui {

/// Meaning of the executed path's colour: a quantity of the motion that has colours, by its QuantityId
/// (listed here if the code refers to it), or one that needs more than the motion.
enum class Colouring : std::uint8_t {
  feed = static_cast<std::uint8_t>(QuantityId::feed),
  feed_ratio = static_cast<std::uint8_t>(QuantityId::feed_ratio),
  tangential_acceleration = static_cast<std::uint8_t>(QuantityId::tangential_acceleration),
  acceleration = static_cast<std::uint8_t>(QuantityId::acceleration),
  tangential_jerk = static_cast<std::uint8_t>(QuantityId::tangential_jerk),
  jerk = static_cast<std::uint8_t>(QuantityId::jerk),
  actual_contour_error = static_cast<std::uint8_t>(QuantityId::actual_contour_error),
  following_error = static_cast<std::uint8_t>(QuantityId::following_error),
  peak_force = static_cast<std::uint8_t>(QuantityId::peak_force),
  chip_thickness = static_cast<std::uint8_t>(QuantityId::chip_thickness),
  contour_error = static_cast<std::uint8_t>(quantity_count),  ///< distance from the programmed path [mm]
  time_lost,                                                  ///< against another run, below 0: gained [s/mm]
  path_distance,                                              ///< from the executed path of another run [mm]
  cause,                                                      ///< limiting cause
  run,                                                        ///< the run's own colour
};
inline constexpr std::size_t colouring_count = static_cast<std::size_t>(Colouring::run) + 1;

/// In the order of lists.
const std::vector<Colouring>& all_colourings();
/// Stable key for sessions: "feed", "contour_error".
std::string colouring_key(Colouring colouring);
/// The quantity of the motion of a colouring; nullptr for the others.
const QuantityInfo* quantity_of(Colouring colouring);

/// Whether a colouring needs another run to compare with.
constexpr bool needs_reference(Colouring colouring) {
  return colouring == Colouring::time_lost || colouring == Colouring::path_distance;
}

/// Source that a run needs for this colouring.
QuantitySource source_of(Colouring colouring);

/// Number of colourings with values stored at every point of a path, and the index of each among them;
/// contour_error is computed on request.
inline constexpr std::size_t sampled_count = coloured_count + 2;
inline constexpr std::size_t own_sampled_count = coloured_count;  ///< that need no other run
std::size_t sample_index(Colouring colouring);
/// Source of the values at this index.
QuantitySource source_of_sample(std::size_t sample);

}  // namespace feedscope::ui
