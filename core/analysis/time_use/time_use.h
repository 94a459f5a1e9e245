#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/analysis/run.h"
#include "core/analysis/study/operations.h"

namespace feedscope {

/// What the time of a run is spent on.
enum class TimeKind : std::uint8_t { cutting, rapid, dwell, tool_change, spindle_start, indexing };
inline constexpr std::size_t time_kind_count = static_cast<std::size_t>(TimeKind::indexing) + 1;
/// Stable key for files: "cutting", "rapid", "dwell", "tool_change", "spindle_start", "indexing".
std::string_view time_kind_key(TimeKind kind);
/// For people: "feed motions", "rapids" ...
std::string_view time_kind_title(TimeKind kind);

/// A part of the cycle time, and what the same part of the program takes at its programmed feed.
struct TimeShare {
  double time = 0;        ///< [s]
  double programmed = 0;  ///< [s]
  double lost() const { return time - programmed; }
};

/// What a limiting cause takes and what it costs.
struct CauseCost {
  Cause cause;
  double time = 0;  ///< [s]
  double lost = 0;  ///< beyond the time of the executed path at its programmed feed [s]
};

struct OperationTime {
  std::string title;       ///< as Operation::title
  std::uint32_t line = 0;  ///< that it begins with
  double start = 0;        ///< first instant of it [s]
  TimeShare all;
  double rapid = 0;  ///< part of all.time [s]
  double pause = 0;  ///< part of all.time: dwells, tool changes, spindle starts [s]
  CauseCost worst;   ///< the cause that loses most in it
  /// Whether that is enough to be named: more than 0.05 % of the operation's own time.
  bool loses() const { return worst.lost > 5e-4 * all.time; }
};

/// Where the cycle time of a run goes, in three ways, each of which adds up to all of it.
///
/// cycle_time = programmed_time - saved_by_path + the `lost` of all causes
///            = the `time` of all kinds = of all causes = of all operations
/// programmed_time = the `programmed` of all kinds = of all operations
struct TimeUse {
  double cycle_time = 0;       ///< [s]
  double programmed_time = 0;  ///< as Summary::programmed_time [s]
  /// Programmed time less that of the executed path at its programmed feed: corners that are cut make the
  /// path shorter [s]; negative where the executed path is longer, or where its blends run at the lower of
  /// two programmed feeds.
  double saved_by_path = 0;
  double longer_path = 0;                        ///< executed length less the programmed one [mm]
  double mean_feed = 0;                          ///< Summary::mean_feed, without the pauses [mm/s]
  std::array<TimeShare, time_kind_count> kinds;  ///< by TimeKind
  /// Those with any time, that which loses most first; slowing down counts for what sets the speed of the
  /// slower place ahead.
  std::vector<CauseCost> causes;
  OperationSplit split = OperationSplit::none;
  std::vector<OperationTime>
      operations;  ///< in the order of their first start; not split as asked, empty where there is one only

  double lost() const { return cycle_time - programmed_time; }
  const TimeShare& of(TimeKind kind) const { return kinds[static_cast<std::size_t>(kind)]; }
  /// Time in which the tool stands because the program or the machine says so [s].
  double pauses() const {
    return of(TimeKind::dwell).time + of(TimeKind::tool_change).time + of(TimeKind::spindle_start).time +
           of(TimeKind::indexing).time;
  }
};

/// What TimeUse::saved_by_path is, for people: "path shorter than programmed", "path longer than programmed",
/// or where the length does not say it "path at a lower programmed feed", "path at a higher programmed feed".
std::string_view path_title(const TimeUse& use);

/// Linear in pieces and segments. `split` none: by tool where more than one works, else by comment where they
/// make two to 200 operations, else not at all. An operation that a loop comes back to is one.
/// Throws Cancelled.
TimeUse time_use(const Run& run, OperationSplit split = OperationSplit::none, Progress* progress = nullptr);

}  // namespace feedscope
