#include "core/analysis/fastest_runs.h"

#include <algorithm>
#include <limits>

namespace feedscope {
namespace {

constexpr double rounding = 1e-9;  // of the time; of errors [mm]

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
  const auto keep_least = [&](double RunTime::*figure, double share, double more) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : fastest) {
      least = std::min(least, runs[i].*figure);
    }
    std::erase_if(fastest, [&](std::size_t i) { return runs[i].*figure > least * (1 + share) + more; });
  };
  keep_least(&RunTime::cycle_time, worthwhile_share, 0);
  keep_least(&RunTime::contour_error, 0, rounding);
  keep_least(&RunTime::cycle_time, rounding, 0);
  return fastest;
}

}  // namespace feedscope
