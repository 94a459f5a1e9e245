#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace feedscope {

/// With what a run competes for being the fastest.
struct RunTime {
  double cycle_time = 0;          ///< [s]
  double contour_error = 0;       ///< largest [mm]
  std::size_t lines_not_run = 0;  ///< that the control refuses
  bool competes = true;           ///< false: refused as a whole, or nothing is known of it
};

/// Whether a contour error keeps a bound [mm]; true without one.
bool keeps_bound(double contour_error, std::optional<double> within);

/// Places in `runs` of those that can be taken, rising: they compete, and their contour error is at most
/// `within` [mm]. Never one of which the control refuses more lines than of another that competes: what is
/// not run takes no time.
std::vector<std::size_t> runs_to_choose_from(std::span<const RunTime> runs, std::optional<double> within);

/// Of runs_to_choose_from() the fastest, rising: all that take the same time to a billionth, of these those
/// with the least error.
std::vector<std::size_t> fastest_runs(std::span<const RunTime> runs, std::optional<double> within);

}  // namespace feedscope
