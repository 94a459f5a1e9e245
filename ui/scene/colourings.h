#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/quantity.h"

namespace feedscope::ui {

/// What the colour of the executed path says: a quantity of the motion that has colours, by its QuantityId,
/// of which those that the program names are listed here, or one of what needs more than the motion.
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
  path_distance,  ///< from the path that another run executes [mm]
  cause,          ///< limiting cause
  run,            ///< the run's own colour
};
inline constexpr std::size_t colouring_count = static_cast<std::size_t>(Colouring::run) + 1;

/// In the order in which they are listed.
const std::vector<Colouring>& all_colourings();
/// Stable key for sessions: "feed", "contour_error".
std::string colouring_key(Colouring colouring);
/// The quantity of the motion that it shows; nullptr for the others.
const QuantityInfo* quantity_of(Colouring colouring);

/// Whether a colouring needs another run to compare with.
constexpr bool needs_reference(Colouring colouring) {
  return colouring == Colouring::time_lost || colouring == Colouring::path_distance;
}

/// What a run must have so that it can be coloured.
QuantitySource source_of(Colouring colouring);

/// Colourings whose values are kept at every point of a path, and the position of one among them; those of
/// contour_error are found when they are asked for.
inline constexpr std::size_t sampled_count = coloured_count + 2;
inline constexpr std::size_t own_sampled_count = coloured_count;  ///< that need no other run
std::size_t sample_index(Colouring colouring);
/// What the values at this position are of.
QuantitySource source_of_sample(std::size_t sample);

}  // namespace feedscope::ui
