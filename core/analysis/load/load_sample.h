#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace feedscope {

/// Cutting load at one feed; definitions in core/load/README.md.
struct CuttingLoad {
  double feed_per_tooth = 0;  ///< [mm]
  double chip_thickness = 0;  ///< largest of a tooth during the cut [mm]
  double mean_force = 0;      ///< length of the mean force in the plane across the tool [N]
  double peak_force = 0;      ///< largest force in that plane over a revolution [N]
  double torque = 0;          ///< mean over a revolution [N mm]
  double power = 0;           ///< mean over a revolution [N mm/s]
};

/// Whether a motion has a load, or why not.
enum class LoadState : std::uint8_t {
  cutting,
  rapid,
  dwell,         ///< dwells, pauses and moves of unknown path
  no_operation,  ///< a feed motion without an operation in the load file
  plunge,        ///< steeper than 45 degrees: plunging, drilling
  no_spindle,    ///< the spindle is at rest, or its speed is unknown
};
inline constexpr std::size_t load_state_count = 6;
/// Keys of JSON files: "cutting", "no_operation" ...
std::string_view key_of(LoadState state);

/// Load at one instant.
struct LoadSample {
  LoadState state = LoadState::no_operation;
  int operation = -1;      ///< index of LoadModel::operations(); -1: none
  CuttingLoad predicted;   ///< at the feed of the run; 0 unless `state` is cutting
  CuttingLoad programmed;  ///< at the programmed feed, at the same place
  bool has_load() const { return state == LoadState::cutting; }
};

}  // namespace feedscope
