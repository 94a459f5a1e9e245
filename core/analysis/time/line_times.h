#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/program/machine_move.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Time and motion of one or several source lines in a run.
struct LineTime {
  double time = 0;         ///< sum over all passes of loops and calls [s]
  double length = 0;       ///< executed on the lines [mm]
  double dwell = 0;        ///< part of `time` in which the program waits [s]
  std::uint64_t runs = 0;  ///< how often the run entered the line from another one, or from the start

  /// Mean feed in motion [mm/s]; 0 for lines that do not move.
  double mean_feed() const { return time > dwell ? length / (time - dwell) : 0; }
};

/// Time of a run by source line: 36 bytes per line, any range read in constant time.
///
/// A corner that the control rounds counts for the line that ends there. The times of all lines add up to the
/// cycle time.
class LineTimes {
 public:
  LineTimes() = default;
  /// Linear in the pieces of `trajectory`. Throws Cancelled.
  explicit LineTimes(const Trajectory& trajectory, Progress* progress = nullptr);

  /// Last line that takes time or is run; 0 for an empty run.
  std::uint32_t line_count() const {
    return static_cast<std::uint32_t>(ends_.empty() ? 0 : ends_.size() - 1);
  }
  /// Cycle time [s].
  double total() const { return ends_.empty() ? 0 : ends_.back().time; }
  /// Time of the slowest line [s].
  double largest() const { return largest_; }
  /// One line, 1-based; zero if it does not run.
  LineTime of(std::uint32_t line) const { return of(line, line); }
  /// Lines `first` to `last`, inclusive.
  LineTime of(std::uint32_t first, std::uint32_t last) const;
  /// First element of the path from the line, or from the next one that runs; none after the last.
  std::optional<std::uint32_t> first_element(std::uint32_t line) const;
  /// Events of the line whose time on the machine is unknown and not included, each kind once; empty if none.
  std::vector<Pause> not_counted(std::uint32_t line) const;

 private:
  std::vector<LineTime> ends_;           ///< [n]: lines 1 to n together
  std::vector<std::uint32_t> elements_;  ///< [n]: the first one of line n or of the next line that runs
  /// By line and kind, each once.
  std::vector<std::pair<std::uint32_t, Pause>> not_counted_;
  double largest_ = 0;
};

}  // namespace feedscope
