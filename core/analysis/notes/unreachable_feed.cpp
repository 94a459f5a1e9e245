#include "core/analysis/notes/unreachable_feed.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

std::optional<LargestFeed> largest_feed_of(const Toolpath& path) {
  LargestFeed largest;
  for (const Segment& segment : path.segments) {
    if (segment.feed > largest.feed) {
      largest = {segment.feed, segment.line};
    }
  }
  return largest.feed > 0 ? std::optional(largest) : std::nullopt;
}

std::optional<UnreachableFeed> unreachable_feed(const std::optional<LargestFeed>& programmed,
                                                const Toolpath& path, const Machine& machine) {
  if (!programmed || std::ranges::any_of(path.segment_turns, &SegmentTurn::at_tip)) {
    return std::nullopt;
  }
  double squares = 0;
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    squares += machine.axes[i].velocity * machine.axes[i].velocity;
  }
  const double reachable = std::sqrt(squares);
  return programmed->feed > reachable ? std::optional(UnreachableFeed{*programmed, reachable}) : std::nullopt;
}

}  // namespace feedscope
