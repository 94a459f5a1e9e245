#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// The largest feed that a program asks for, and the first line that runs with it.
struct LargestFeed {
  double feed = 0;  ///< [mm/s]
  std::uint32_t line = 0;
};
/// None where nothing moves at a feed.
std::optional<LargestFeed> largest_feed_of(const Toolpath& path);

/// A feed that all linear axes of a machine together do not reach in any direction: often a slip of the pen.
/// What is lost against such a feed tells nothing.
struct UnreachableFeed {
  LargestFeed programmed;
  double reachable = 0;  ///< along a diagonal, by the velocities of X, Y and Z [mm/s]
};
/// `path`: as the machine runs it; none where rotary axes turn with the tip held, as they move the tip too.
std::optional<UnreachableFeed> unreachable_feed(const std::optional<LargestFeed>& programmed,
                                                const Toolpath& path, const Machine& machine);
/// As one sentence.
Message describe(const UnreachableFeed& feed);

}  // namespace feedscope
