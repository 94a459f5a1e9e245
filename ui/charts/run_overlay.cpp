#include "ui/charts/run_overlay.h"

#include <algorithm>

#include "core/analysis/programmed_place.h"

namespace feedscope::ui {

std::optional<CuttingFeed> cutting_feed(const Envelope* run, std::span<const Band> shown,
                                        std::span<const RunOverlay> beside) {
  if (run == nullptr || run->cutting()[Channel::feed].empty()) {
    return std::nullopt;
  }
  Extent programmed;
  for (const Band& band : shown) {
    programmed.add(band[Channel::programmed_feed]);
  }
  if (programmed.min > run->cutting()[Channel::programmed_feed].max) {
    return std::nullopt;
  }
  CuttingFeed feed{run->cutting()[Channel::feed].max, run->cutting()[Channel::programmed_feed].max};
  for (const RunOverlay& overlay : beside) {
    feed.achieved = std::max(feed.achieved, double{overlay.envelope->cutting()[Channel::feed].max});
  }
  return feed;
}

double same_place(const BlendedPath& from, double s, const BlendedPath& to) {
  return from.empty() || to.empty() ? 0 : path_length_of(to, programmed_place(from, s));
}

}  // namespace feedscope::ui
