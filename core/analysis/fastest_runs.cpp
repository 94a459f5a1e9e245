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

std::vector<std::size_t> fastest_runs(std::span<const RunTime> runs, std::optional<double> within) {
  std::size_t least_not_run = std::numeric_limits<std::size_t>::max();
  for (const RunTime& run : runs) {
    least_not_run = run.competes ? std::min(least_not_run, run.lines_not_run) : least_not_run;
  }
  const auto counts = [&](const RunTime& run) {
    return run.competes && run.lines_not_run == least_not_run && keeps_bound(run.contour_error, within);
  };
  double time = std::numeric_limits<double>::infinity();
  for (const RunTime& run : runs) {
    time = counts(run) ? std::min(time, run.cycle_time) : time;
  }
  const auto is_fast = [&](const RunTime& run) {
    return counts(run) && run.cycle_time <= time * (1 + rounding);
  };
  double error = std::numeric_limits<double>::infinity();
  for (const RunTime& run : runs) {
    error = is_fast(run) ? std::min(error, run.contour_error) : error;
  }
  std::vector<std::size_t> fastest;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (is_fast(runs[i]) && runs[i].contour_error <= error + rounding) {
      fastest.push_back(i);
    }
  }
  return fastest;
}

}  // namespace feedscope
