#include "core/analysis/notes/unreachable_feed.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

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

Message describe(const UnreachableFeed& feed) {
  return message(NC_("core",
                     "Line {} asks for a feed of {:.0f} mm/min; all axes of this machine together reach "
                     "{:.0f} mm/min: what is lost against the programmed feed tells little there."),
                 feed.programmed.line, units::to_mm_min(feed.programmed.feed),
                 units::to_mm_min(feed.reachable));
}

}  // namespace feedscope
