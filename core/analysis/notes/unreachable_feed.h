#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Largest feed of a program, and the first line that runs at it.
struct LargestFeed {
  double feed = 0;  ///< [mm/s]
  std::uint32_t line = 0;
};
/// None without a motion at a feed.
std::optional<LargestFeed> largest_feed_of(const Toolpath& path);

/// A feed that all linear axes of a machine together cannot reach in any direction: often a typing error.
/// Time lost against such a feed has no significance.
struct UnreachableFeed {
  LargestFeed programmed;
  double reachable = 0;  ///< along a diagonal, from the velocities of X, Y and Z [mm/s]
};
/// `path`: as the machine runs it. None if rotary axes turn with the tip controlled, since they move the tip
/// too.
std::optional<UnreachableFeed> unreachable_feed(const std::optional<LargestFeed>& programmed,
                                                const Toolpath& path, const Machine& machine);

}  // namespace feedscope
