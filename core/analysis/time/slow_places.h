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

/// A stretch of a run around one dip of the feed below the programmed feed.
struct SlowPlace {
  double from = 0;               ///< the feed falls below the programmed feed [s]
  double to = 0;                 ///< it reaches the programmed feed again, or the next place begins [s]
  double slowest = 0;            ///< instant of the smallest share of the programmed feed [s]
  double loss = 0;               ///< time beyond that of the same path at the programmed feed [s]
  double feed = 0;               ///< achieved at `slowest` [mm/s]
  double programmed_feed = 0;    ///< at `slowest` [mm/s]; for a rapid the axes' speed along it
  std::uint32_t line = 0;        ///< at `slowest`
  std::uint32_t first_line = 0;  ///< smallest source line of the stretch
  std::uint32_t last_line = 0;   ///< largest
  /// Cause of most of `loss`; slowing down counts for the cause of the slower place ahead.
  Cause cause;
};

/// Places where a run loses time against its programmed feed.
struct SlowPlaces {
  std::vector<SlowPlace> places;  ///< in order of time
  std::size_t count = 0;          ///< including omitted ones
  /// Stretches between the places, in order of time: faster than programmed, or hardly slower; the omitted
  /// ones gain and lose least. Their `slowest` has the smallest share, however large.
  std::vector<SlowPlace> others;
  double loss = 0;  ///< total [s]: cycle time minus dwells minus the path at its programmed feeds
};

/// A place, or the stretch between two (as SlowPlaces::others), and the loss of each cause there [s].
using VisitStretch = std::function<void(const SlowPlace& stretch, bool is_place,
                                        std::span<const std::pair<Cause, double>> losses)>;

/// Divides a run at the highest feeds between its dips, as shares of the programmed feed, and visits all
/// stretches in order of time. A dip must be at least a tenth of the programmed feed deep on both sides, or
/// three tenths of the feed next to it if that is less: otherwise a feed that the machine never approaches
/// would have no dips. Start and end of a run are dips. A place also ends where a rapid begins or ends.
/// Returns the sum of all losses [s]. Linear in the pieces. Throws Cancelled.
double for_slow_stretches(const Trajectory& trajectory, const VisitStretch& visit,
                          Progress* progress = nullptr);

/// Returns the places of for_slow_stretches() and the stretches between them.
///
/// Linear in the pieces. Of more than `most` places, and of more other stretches, keeps the most important
/// ones. Samples blends and filtered motion at a few instants of each piece. Throws Cancelled.
SlowPlaces find_slow_places(const Trajectory& trajectory, std::size_t most = 10'000,
                            Progress* progress = nullptr);

}  // namespace feedscope
