#include "core/analysis/study/fastest_runs.h"

#include <algorithm>
#include <limits>

namespace feedscope {
namespace {

constexpr double rounding = 1e-9;  // of the time, relative; of errors [mm]

}  // namespace

bool keeps_bound(double contour_error, std::optional<double> within) {
  return !within || contour_error <= *within + rounding;
}

std::vector<std::size_t> runs_to_choose_from(std::span<const RunTime> runs, std::optional<double> within) {
  std::size_t least_not_run = std::numeric_limits<std::size_t>::max();
  for (const RunTime& run : runs) {
    least_not_run = run.competes ? std::min(least_not_run, run.lines_not_run) : least_not_run;
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunTime& run = runs[i];
    if (run.competes && run.lines_not_run == least_not_run && keeps_bound(run.contour_error, within)) {
      places.push_back(i);
    }
  }
  return places;
}

std::vector<std::size_t> fastest_runs(std::span<const RunTime> runs, std::optional<double> within) {
  std::vector<std::size_t> fastest = runs_to_choose_from(runs, within);
  double time = std::numeric_limits<double>::infinity();
  for (const std::size_t i : fastest) {
    time = std::min(time, runs[i].cycle_time);
  }
  std::erase_if(fastest, [&](std::size_t i) { return runs[i].cycle_time > time * (1 + rounding); });
  double error = std::numeric_limits<double>::infinity();
  for (const std::size_t i : fastest) {
    error = std::min(error, runs[i].contour_error);
  }
  std::erase_if(fastest, [&](std::size_t i) { return runs[i].contour_error > error + rounding; });
  return fastest;
}

}  // namespace feedscope
