#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace feedscope {

/// Criteria by which a run may be the fastest.
struct RunTime {
  double cycle_time = 0;          ///< [s]
  double contour_error = 0;       ///< largest [mm]
  std::size_t lines_not_run = 0;  ///< refused by the control
  bool competes = true;           ///< false: refused as a whole, or without figures
};

/// Whether a contour error is within a bound [mm]; true without one.
bool keeps_bound(double contour_error, std::optional<double> within);

/// Indices into `runs` of the eligible ones, ascending: they compete, and their contour error is at most
/// `within` [mm]. A run of which the control refuses more lines than of another one is never eligible:
/// skipped lines take no time.
std::vector<std::size_t> runs_to_choose_from(std::span<const RunTime> runs, std::optional<double> within);

/// The fastest of runs_to_choose_from(), ascending: all with the same time within a billionth, of these those
/// with the smallest error.
std::vector<std::size_t> fastest_runs(std::span<const RunTime> runs, std::optional<double> within);

}  // namespace feedscope
