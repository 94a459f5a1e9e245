#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace feedscope {

/// Differences of the cycle time below this share are none.
inline constexpr double worthwhile_share = 0.01;

/// With what a run competes for being the fastest.
struct RunTime {
  double cycle_time = 0;          ///< [s]
  double contour_error = 0;       ///< largest of its cuts, with drives of what the axes do [mm]
  std::size_t lines_not_run = 0;  ///< that the control refuses
  bool competes = true;           ///< false: refused as a whole, or nothing is known of it
};

/// Whether a contour error keeps a bound [mm]; true without one.
bool keeps_bound(double contour_error, std::optional<double> within);

/// Places in `runs` of those that can be taken, rising: they compete, and their contour error is at most
/// `within` [mm]. Never one of which the control refuses more lines than of another that competes: what is
/// not run takes no time.
std::vector<std::size_t> runs_to_choose_from(std::span<const RunTime> runs, std::optional<double> within);

/// Of runs_to_choose_from() the fastest, rising. Those that take at most worthwhile_share longer are as fast:
/// of these the ones with the least error, and of equal errors (to 1e-9 mm) the fastest to a billionth.
std::vector<std::size_t> fastest_runs(std::span<const RunTime> runs, std::optional<double> within);

}  // namespace feedscope
