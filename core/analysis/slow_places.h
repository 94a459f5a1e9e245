#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// A stretch of a run around one dip of the feed below what is programmed.
struct SlowPlace {
  double from = 0;               ///< it gets slower than programmed [s]
  double to = 0;                 ///< it is as fast as programmed again, or the next place begins [s]
  double slowest = 0;            ///< instant of the least share of the programmed feed [s]
  double loss = 0;               ///< time beyond that of the same path at the programmed feed [s]
  double feed = 0;               ///< achieved at `slowest` [mm/s]
  double programmed_feed = 0;    ///< there [mm/s]; for a rapid the axes' speed along it
  std::uint32_t line = 0;        ///< at `slowest`
  std::uint32_t first_line = 0;  ///< least source line of the stretch
  std::uint32_t last_line = 0;   ///< largest
  /// That most of `loss` is due to; slowing down counts for what sets the speed of the slower place ahead.
  Cause cause;
};

/// Where a run loses time against its programmed feed.
struct SlowPlaces {
  std::vector<SlowPlace> places;  ///< in order of time
  std::size_t count = 0;          ///< also of those that are omitted
  /// The stretches between them, in order of time: faster than programmed, or hardly slower; those that are
  /// omitted gain and lose least. Their `slowest` is that of the least share, however large.
  std::vector<SlowPlace> others;
  double loss = 0;  ///< of all [s]: cycle time less dwells less the path at its programmed feeds
};

/// A place, or the stretch between two (as SlowPlaces::others), and what each cause loses there [s].
using VisitStretch = std::function<void(const SlowPlace& stretch, bool is_place,
                                        std::span<const std::pair<Cause, double>> losses)>;

/// Cuts a run at the highest feeds between its dips, as shares of the programmed feed, and visits all
/// stretches in order of time. A dip is one if it is at least a tenth of the programmed feed deep on both
/// sides, or three tenths of the feed beside it where that is less: a feed that the machine never comes near
/// would have no dip. Start and end of a run are dips. Where a rapid begins or ends a place ends, too.
/// Returns the sum of all losses [s]. Linear in the pieces. Throws Cancelled.
double for_slow_stretches(const Trajectory& trajectory, const VisitStretch& visit,
                          Progress* progress = nullptr);

/// The places of for_slow_stretches(), and the stretches between them.
///
/// Linear in the pieces; of more than `most` places, and of more others, those that matter most are kept.
/// Blends and filtered motion are looked at in a few instants of each piece. Throws Cancelled.
SlowPlaces find_slow_places(const Trajectory& trajectory, std::size_t most = 10'000,
                            Progress* progress = nullptr);

}  // namespace feedscope
