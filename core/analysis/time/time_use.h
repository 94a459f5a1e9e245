#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/analysis/study/operations.h"

namespace feedscope {

/// Kinds of motion and pause that the time of a run is spent on.
enum class TimeKind : std::uint8_t { cutting, rapid, dwell, tool_change, spindle_start, indexing };
inline constexpr std::size_t time_kind_count = static_cast<std::size_t>(TimeKind::indexing) + 1;
/// Stable key for files: "cutting", "rapid", "dwell", "tool_change", "spindle_start", "indexing".
std::string_view time_kind_key(TimeKind kind);
/// Title for display: "feed motions", "rapids" ...
std::string_view time_kind_title(TimeKind kind);

/// Part of the cycle time, and the time of the same part of the program at its programmed feed.
struct TimeShare {
  double time = 0;        ///< [s]
  double programmed = 0;  ///< [s]
  double lost() const { return time - programmed; }
};

/// Time and cost of a limiting cause.
struct CauseCost {
  Cause cause;
  double time = 0;  ///< [s]
  double lost = 0;  ///< beyond the time of the executed path at its programmed feed [s]
};

struct OperationTime {
  std::string title;       ///< as Operation::title
  std::uint32_t line = 0;  ///< first line
  double start = 0;        ///< first instant [s]
  TimeShare all;
  double rapid = 0;  ///< part of all.time [s]
  double pause = 0;  ///< part of all.time: dwells, tool changes, spindle starts [s]
  CauseCost worst;   ///< the cause with the largest loss
  /// Whether the loss is worth reporting: more than 0.05 % of the operation's own time.
  bool loses() const { return worst.lost > 5e-4 * all.time; }
};

/// Breakdown of the cycle time of a run in three ways, each of which adds up to all of it.
///
/// cycle_time = programmed_time - saved_by_path + the `lost` of all causes
///            = the `time` of all kinds = of all causes = of all operations
/// programmed_time = the `programmed` of all kinds = of all operations
struct TimeUse {
  double cycle_time = 0;       ///< [s]
  double programmed_time = 0;  ///< as Summary::programmed_time [s]
  /// Programmed time minus that of the executed path at its programmed feed [s]: cut corners shorten the
  /// path. Negative if the executed path is longer, or if its blends run at the lower of two programmed
  /// feeds.
  double saved_by_path = 0;
  double longer_path = 0;                        ///< executed minus programmed length [mm]
  double mean_feed = 0;                          ///< Summary::mean_feed, without the pauses [mm/s]
  std::array<TimeShare, time_kind_count> kinds;  ///< by TimeKind
  /// Causes with any time, largest loss first; slowing down counts for the cause of the slower place ahead.
  std::vector<CauseCost> causes;
  OperationSplit split = OperationSplit::none;
  std::vector<OperationTime>
      operations;  ///< in order of first start; empty if there is only one or without a split

  double lost() const { return cycle_time - programmed_time; }
  const TimeShare& of(TimeKind kind) const { return kinds[static_cast<std::size_t>(kind)]; }
  /// Time in which the tool stops by order of the program or the machine [s].
  double pauses() const {
    return of(TimeKind::dwell).time + of(TimeKind::tool_change).time + of(TimeKind::spindle_start).time +
           of(TimeKind::indexing).time;
  }
};

/// Title of TimeUse::saved_by_path for display: "path shorter than programmed", "path longer than
/// programmed", or if the lengths are equal "path at a lower programmed feed", "path at a higher programmed
/// feed".
std::string_view path_title(const TimeUse& use);

/// Linear in pieces and segments. `split` none: by tool if more than one is used, else by comment if that
/// gives two to 200 operations, else not at all. An operation that a loop returns to counts as one. Throws
/// Cancelled.
TimeUse time_use(const Run& run, OperationSplit split = OperationSplit::none, Progress* progress = nullptr);

}  // namespace feedscope
