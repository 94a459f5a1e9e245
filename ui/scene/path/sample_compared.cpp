#include <algorithm>

#include "core/analysis/difference/run_difference.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {
namespace {

constexpr std::size_t close_enough = 300'000;  // points of one path

/// Where the reference changes its feed, as times of the run.
std::vector<double> places_of(const Trajectory& reference, const Trajectory& run) {
  const std::vector<double> times = sample_executed(reference).times;
  return times.size() > close_enough ? std::vector<double>() : times_at_places(reference, run, times);
}

}  // namespace

SampledPath sample_compared(const Trajectory& trajectory, const Trajectory& reference, Progress* progress) {
  SampledPath path = sample_executed(trajectory, default_max_points, places_of(reference, trajectory));
  const RunDifference difference = compare_places(trajectory, reference, path.times, progress);
  const auto store = [](std::vector<Stored>& to, const std::vector<float>& from) {
    to.reserve(from.size());
    std::ranges::transform(from, std::back_inserter(to), [](float value) { return Stored(value); });
  };
  store(path.values[static_cast<std::size_t>(Quantity::time_lost)], difference.pace);
  store(path.values[static_cast<std::size_t>(Quantity::path_distance)], difference.distance);
  path.lost.reserve(difference.lost.size());
  std::ranges::transform(difference.lost, std::back_inserter(path.lost),
                         [](double lost) { return static_cast<float>(lost); });
  return path;
}

}  // namespace feedscope::ui
